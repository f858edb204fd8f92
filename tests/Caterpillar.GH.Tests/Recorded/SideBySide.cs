#if NET
using NUnit.Framework;

// What the stand-ins keep of a host is kept for each thread; Rhino's own is not.
[assembly: Parallelizable(ParallelScope.Fixtures)]
#endif
