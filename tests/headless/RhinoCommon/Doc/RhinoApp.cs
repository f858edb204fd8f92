using System;
using System.Collections.Generic;

namespace Rhino
{
    public static class RhinoApp
    {
        // A test may be a server.
        internal static bool Headless;

        // Tests run side by side: each thread has its own.
        [ThreadStatic]
        private static List<string> s_lines;

        // What was written to the command line.
        internal static List<string> Lines => s_lines ?? (s_lines = new List<string>());

        public static bool IsRunningHeadless => Headless;

        public static void WriteLine(string message) => Lines.Add(message);

        public static void InvokeOnUiThread(Delegate method, params object[] args) => method.DynamicInvoke(args);
    }
}

namespace Rhino.Commands
{
    public enum Result
    {
        Success = 0,
        Cancel = 1,
        Nothing = 2,
        Failure = 3,
    }
}

namespace Rhino.Input
{
    public static class RhinoGet
    {
        // What the user of a test types, in order; without more the command is canceled.
        internal static readonly Queue<string> Answers = new Queue<string>();

        // The curves that the user of a test picks.
        internal static readonly Queue<DocObjects.ObjRef> Picks = new Queue<DocObjects.ObjRef>();

        public static Commands.Result GetOneObject(string prompt, bool acceptNothing, DocObjects.ObjectType filter, out DocObjects.ObjRef rhObject)
        {
            rhObject = Picks.Count > 0 ? Picks.Dequeue() : null;
            return rhObject == null ? Commands.Result.Cancel : Commands.Result.Success;
        }

        public static Commands.Result GetMultipleObjects(string prompt, bool acceptNothing, DocObjects.ObjectType filter, out DocObjects.ObjRef[] rhObjects)
        {
            rhObjects = Picks.ToArray();
            Picks.Clear();
            return rhObjects.Length == 0 ? Commands.Result.Cancel : Commands.Result.Success;
        }

        public static Commands.Result GetString(string prompt, bool acceptNothing, ref string outputString)
        {
            if (Answers.Count == 0) return Commands.Result.Cancel;
            outputString = Answers.Dequeue();
            return outputString.Length > 0 ? Commands.Result.Success : acceptNothing ? Commands.Result.Nothing : Commands.Result.Cancel;
        }
    }
}

namespace Rhino.UI
{
    public static class StatusBar
    {
        // Tests run side by side: each thread has its own.
        [ThreadStatic]
        private static List<string> s_log;

        // What was asked of the progress meter, in order.
        internal static List<string> Log => s_log ?? (s_log = new List<string>());

        public static int ShowProgressMeter(int lowerLimit, int upperLimit, string label, bool embedLabel, bool showPercentComplete)
        {
            Log.Add("show " + label);
            return 1;
        }

        public static int UpdateProgressMeter(int position, bool absolute)
        {
            Log.Add("at " + position);
            return position;
        }

        public static void HideProgressMeter() => Log.Add("hide");
    }
}
