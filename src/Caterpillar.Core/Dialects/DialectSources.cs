namespace Caterpillar.Dialects;

/// <summary>Where the rules of <see cref="DialectTable"/> stand, and what a table cannot say about them.</summary>
internal static class DialectSources
{
    public const string Slicer = "PrusaSlicer 2.9.4, src/libslic3r/GCode/GCodeProcessor.cpp: process_gcode_line, process_G1, process_G2_G3, process_G28, "
        + "process_G92, process_T";
    public const string SlicerNotes =
        "The neutral reading of files. Where the processor of PrusaSlicer stops, it goes on as most machines do: lines without G repeat the last motion, "
        + "arcs may lie in other planes, have absolute centers or P, and one without a center is a line; M101 and M103 and the letters A and B extrude.";

    public const string Marlin1 =
        "Marlin 1.1, Marlin/Marlin_main.cpp: gcode_get_destination, gcode_G2_G3, gcode_G4, gcode_G92, gcode_M200, gcode_M220, gcode_M221, tool_change";
    public const string MarlinNotes =
        "G10 and G11, G17 to G19, G20, G92.1 and P of arcs are build options, taken as built in; workspaces (G53 to G59), saved positions (G60, G61), "
        + "splines (G5) and motion without G are options too, taken as not built in.";

    public const string Marlin2 =
        "Marlin 2.1, Marlin/src/gcode: gcode.cpp (get_destination_from_command, process_parsed_command), gcode.h (set_relative_mode, axis_is_relative), "
        + "parser.h (axis_unit_factor), motion/G2_G3.cpp (G2_G3, plan_arc), motion/G4.cpp, geometry/G92.cpp, config/M220.cpp, config/M221.cpp, "
        + "config/M200-M205.cpp";

    public const string Prusa = "Prusa-Firmware of 2024-03-28 (MK3), Firmware/Marlin_main.cpp: get_coordinates, process_commands (G2, G3, G4, G21, G90, G91, "
        + "M82, M83, M200, M220, M221, M600, M601), gcode_G28, gcode_G92; Firmware/motion_control.cpp: mc_arc";
    public const string PrusaNotes = "8-bit printers up to the MK3; the MK4, XL and Mini run a Marlin 2.";

    public const string Bambu = "BambuStudio, src/libslic3r/GCode/GCodeProcessor.cpp (commit bca0414): process_G1, process_G2_G3, process_G4, process_G28, "
        + "process_G92, process_M106, process_M221, process_M400, process_M1020, process_T";
    public const string BambuNotes =
        "The firmware is closed: these are the rules by which BambuStudio reads its own files. M220 is in the start code of its printers, but not in that "
        + "source; M0, M1, M25, M600 and M400 U1 as pauses are not either.";

    public const string Klipper =
        "Klipper of 2026-08-07, klippy/extras/gcode_move.py (GCodeMove), gcode_arcs.py (ArcSupport), firmware_retraction.py, fan.py, pause_resume.py, "
        + "virtual_sdcard.py; klippy/toolhead.py (cmd_G4), klippy/kinematics/extruder.py (cmd_ACTIVATE_EXTRUDER)";
    public const string KlipperNotes =
        "T, M600 and the words of a printer's own macros are what its configuration makes of them; T is taken as a change of the extruder, M600 as a pause, "
        + "others do nothing. G2, G3, G10 and G11 need their sections in the configuration, taken as there.";

    public const string RepRapFirmware =
        "RepRapFirmware 3.5.3 (2024-10-23), src/GCodes: GCodes.cpp (DoStraightMove, DoArcMove, LoadExtrusionAndFeedrateFromGCode, DoDwell), GCodes2.cpp "
        + "(HandleGcode, HandleMcode, HandleTcode), GCodes3.cpp (SetPositions, GetSetWorkplaceCoordinates), GCodeMachineState.cpp, "
        + "GCodeBuffer/StringParser.cpp (DecodeCommand, FindParameters)";
    public const string RepRapFirmwareNotes =
        "M0 and M1 end the print. Of an E with several numbers (mixing) the first is read. Homing and tool changes run macros of the machine, which the file "
        + "does not show.";

    public const string Repetier =
        "Repetier-Firmware 1.0.4, src/ArduinoAVR/Repetier: Printer.cpp (setDestinationStepsFromGCode), Commands.cpp (processGCode, processMCode, "
        + "processArc), gcode.cpp (parseAscii), motion.cpp (PrintLine::arc), Extruder.cpp (selectExtruderById)";

    public const string Smoothie =
        "Smoothieware of 2023-07-31, src/modules/robot/Robot.cpp (on_gcode_received, process_move, append_arc), src/modules/tools/extruder/Extruder.cpp "
        + "(on_gcode_received), src/modules/communication/GcodeDispatch.cpp, src/modules/utils/player/Player.cpp";
    public const string SmoothieNotes = "In its mode for 3D printers; in Grbl mode P of G4 is seconds and G28 goes to a stored position.";

    public const string Sailfish =
        "GPX of 2020-11-26, src/gpx/gpx.c (gpx_convert_line, calculate_target_position, queue_ext_point, do_tool_change), which translates G-code to the s3g "
        + "commands that Sailfish executes";
    public const string SailfishNotes =
        "The machine itself reads no G-code: GPX decides, or MakerWare, whose source is closed. A position after homing is the machine's own, stored in it, "
        + "and taken as 0.";

    public const string Cnc = "LinuxCNC of 2026-08-22, src/emc/rs274ngc: interp_convert.cc (convert_arc, convert_axis_offsets, convert_home, convert_setup, "
        + "convert_coordinate_system, convert_stop), interp_arc.cc (arc_data_ijk, arc_data_r), interp_check.cc (check_g_codes), interp_internal.cc "
        + "(enhance_block), interp_find.cc (find_ends)";
    public const string CncNotes =
        "The source of Mach3 is closed: its rules are taken to be those of LinuxCNC. The extruder is a rotary axis, so G20 does not scale it. M1 waits only "
        + "where the operator wants it. Canned cycles are not followed.";

    public const string Ultigcode =
        "Ultimaker2Marlin of 2018-09-16, Marlin/Marlin_main.cpp (get_coordinates, process_commands), Marlin/motion_control.cpp (mc_arc), Marlin/planner.cpp "
        + "(volume_to_filament_length), Marlin/UltiLCD2_menu_print.cpp (;FLAVOR:UltiGCode)";
    public const string UltigcodeNotes =
        "The line ;FLAVOR:UltiGCode makes E a volume, with the diameter that the machine knows; M200 is unknown. Before the file the machine homes, heats "
        + "and primes by itself.";

    public const string Bfb = "CuraEngine of 2026-08-20, src/gcode_export/gcodeExport.cpp (writeMoveBFB, writeRetraction, writeDelay, "
        + "processInitialLayerTemperature)";
    public const string BfbNotes =
        "The firmware is closed: these are the words that CuraEngine writes for it. M108 S sets the revolutions of the extruder per minute (others write ten "
        + "times that), M227 its own retraction; there are no amounts, so none are made up. G92 as most machines take it, T and M0 as a pause are not from "
        + "there; what else the firmware knows is not known.";

    public const string Grbl = "Grbl 1.1h, grbl/gcode.c (gc_execute_line), grbl/gcode.h, grbl/motion_control.c (mc_arc, mc_dwell)";
    public const string GrblNotes =
        "A line with an unknown letter (E, A), or with words that its commands do not use, is refused whole. T is remembered only: there is no tool change. "
        + "M1 does nothing.";
}
