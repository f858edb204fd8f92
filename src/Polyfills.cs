// A type that the C# compiler looks up by name and that netstandard2.0 and net48 lack.
#pragma warning disable IDE0130, MA0048

namespace System.Runtime.CompilerServices;

internal static class IsExternalInit;
