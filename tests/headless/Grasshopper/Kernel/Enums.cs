using System;

namespace Grasshopper.Kernel
{
    public enum GH_ParamAccess
    {
        item = 0,
        list = 1,
        tree = 2,
    }

    public enum GH_RuntimeMessageLevel
    {
        Blank = 0,
        Warning = 10,
        Error = 20,
        Remark = 255,
    }

    [Flags]
    public enum GH_Exposure
    {
        hidden = -1,
        primary = 2,
        secondary = 4,
        tertiary = 8,
        quarternary = 16,
        quinary = 32,
        senary = 64,
        septenary = 128,
        obscure = 65536,
    }

    public enum GH_SolutionPhase
    {
        Blank = 0,
        Collecting = 1,
        Collected = 2,
        Computing = 3,
        Computed = 4,
        Failed = 10,
    }

    public enum GH_SolutionMode
    {
        Default = 0,
        CommandLine = 1,
        Silent = 2,
    }

    public enum GH_ProcessStep
    {
        PreProcess = 0,
        Process = 1,
        PostProcess = 2,
        Aborted = 3,
    }

    public enum GH_DocumentContext
    {
        Unknown = 0,
        None = 1,
        Open = 2,
        Close = 3,
        Loaded = 4,
        Unloaded = 5,
        Lock = 6,
        Unlock = 7,
    }

    public enum GH_DataMapping
    {
        None = 0,
        Flatten = 1,
        Graft = 2,
    }

    public enum GH_ParamKind
    {
        unknown = 0,
        floating = 1,
        input = 2,
        output = 3,
    }

    public enum GH_GetterResult
    {
        accept = 0,
        success = 1,
        cancel = 2,
    }

    public enum GH_LibraryLicense
    {
        unset = 0,
        free = 4,
        opensource = 5,
    }

    public enum GH_LoadingInstruction
    {
        Proceed = 0,
        Abort = 1,
    }
}
