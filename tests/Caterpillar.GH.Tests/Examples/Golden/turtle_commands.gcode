; Made with Caterpillar
; Flavor marlin2
; Printer generic, material pla, settings standard
; filament_diameter = 1.75
;TIME:13
;TYPE:Custom
M107 ; fan off
M140 S60 ; heat the bed
M104 S215 ; heat the nozzle
G28 ; home
M190 S60 ; wait for the bed
M109 S215 ; wait for the nozzle
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
G0 X90 Y90 Z0.2
M73 P58 R0
;TYPE:Unspecified
G1 X120 E1.14019 F1500
M73 P68 R0
G1 Y120 E1.14019
M73 P77 R0
G1 X90 E1.14019
M73 P86 R0
G1 Y90 E1.14019
M73 P96 R0
G4 P500
M73 P100 R0
;TYPE:Custom
G90 ; absolute positions
M83 ; relative E
G1 E-2 F2100
G1 Z10.2 F600
G1 X0 Y220 F6000 ; show the print
M107 ; fan off
M104 S0 ; nozzle off
M140 S0 ; bed off
M84 X Y E ; motors off, Z holds
