; Made with Caterpillar
; Flavor marlin2
; Printer my_printer, material petg, settings standard
; filament_diameter = 1.75
;TIME:12
;TYPE:Custom
M107 ; fan off
M140 S80 ; heat the bed
M104 S235 ; heat the nozzle
G28 ; home
M190 S80 ; wait for the bed
M109 S235 ; wait for the nozzle
G21 ; millimeters
G90 ; absolute positions
M83 ; relative E
G92 E0
G1 Z2 F600
G1 X5 Y20 F6000
G1 Z0.3 F600
G1 Y120 E8.31503 F1200 ; prime
G1 X5.5 F6000
G1 Y20 E8.31503 F1200
G92 E0
G1 Z2 F600
G90
M83
M73 P0 R0
G0 X0 Y0 Z0 F1000
G0 X60 Y60 Z0.3
M73 P41 R0
;TYPE:Unspecified
G1 X80 E1.58556
M73 P51 R0
G1 X90 Y77.321 E1.58556
M73 P60 R0
G1 X80 Y94.641 E1.58556
M73 P70 R0
G1 X60 E1.58556
M73 P80 R0
G1 X50 Y77.321 E1.58556
M73 P90 R0
G1 X60 Y60 E1.58555
M73 P100 R0
;TYPE:Custom
G90 ; absolute positions
M83 ; relative E
G1 E-2 F2100
G1 Z10.3 F600
G1 X0 Y220 F6000 ; show the print
M107 ; fan off
M104 S0 ; nozzle off
M140 S0 ; bed off
M84 X Y E ; motors off, Z holds
