using System;
using System.Collections.Generic;

namespace Rhino
{
    public static class RhinoApp
    {
        public static void InvokeOnUiThread(Delegate method, params object[] args) => method.DynamicInvoke(args);
    }
}

namespace Rhino.UI
{
    public static class StatusBar
    {
        // What was asked of the progress meter, in order.
        internal static readonly List<string> Log = new List<string>();

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
