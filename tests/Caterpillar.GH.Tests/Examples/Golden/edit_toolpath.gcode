; Made with Caterpillar
; Flavor marlin2
; Printer generic, material pla, settings standard
; filament_diameter = 1.75
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
M104 S210
M106 S255
;TYPE:Custom
G90 ; absolute positions
M83 ; relative E
G1 E-2 F2100
G1 Z10 F600
G1 X0 Y220 F6000 ; show the print
M107 ; fan off
M104 S0 ; nozzle off
M140 S0 ; bed off
M84 X Y E ; motors off, Z holds
