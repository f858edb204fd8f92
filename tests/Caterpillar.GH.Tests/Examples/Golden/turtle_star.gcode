; Made with Caterpillar
; Flavor marlin2
; Printer generic, material pla, settings standard
; filament_diameter = 1.75
;TIME:22
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
G0 X110 Y110 Z0.2
M73 P43 R0
;TYPE:Unspecified
G1 X150 E1.52025 F1800
M73 P49 R0
G1 X112.412 Y123.681 E1.52026
M73 P55 R0
G1 X143.054 Y97.969 E1.52025
M73 P62 R0
G1 X123.054 Y132.61 E1.52025
M73 P68 R0
G1 X130 Y93.218 E1.52026
M73 P74 R0
G1 X136.946 Y132.61 E1.52025
M73 P81 R0
G1 X116.946 Y97.969 E1.52025
M73 P87 R0
G1 X147.588 Y123.681 E1.52025
M73 P93 R0
G1 X110 Y110 E1.52026
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
