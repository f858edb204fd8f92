using System.IO.Hashing;

namespace Caterpillar.Cli;

/// <summary>Identifies a run: equal for the same program, options and files.</summary>
internal static class Fingerprint
{
    /// <param name="verb">The verb.</param>
    /// <param name="job">Its words. If a word is a file name, the contents of the file count too.</param>
    public static string Of(Verb verb, BatchJob job)
    {
        // Not the runtime's cryptography, which is OpenSSL on Linux.
        var hash = new XxHash3();
        Add(hash, typeof(Fingerprint).Assembly.GetName().Version!.ToString());
        Add(hash, verb.Name);
        Add(hash, job.Output ?? "");
        foreach (var word in job.Words)
        {
            Add(hash, word);
            if (!File.Exists(word)) continue;
            using var file = new FileStream(word, FileMode.Open, FileAccess.Read, FileShare.Read, 1, FileOptions.SequentialScan);
            hash.Append(BitConverter.GetBytes(file.Length));
            hash.Append(file);
        }
        return Convert.ToHexStringLower(hash.GetCurrentHash());
    }

    private static void Add(XxHash3 hash, string word)
    {
        hash.Append(Encoding.UTF8.GetBytes(word));
        hash.Append([0]);
    }
}
