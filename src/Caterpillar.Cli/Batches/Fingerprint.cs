using System.Security.Cryptography;

namespace Caterpillar.Cli;

/// <summary>Identifies a run: equal for the same program, options and files.</summary>
internal static class Fingerprint
{
    /// <param name="verb">The verb.</param>
    /// <param name="job">Its words. If a word is a file name, the contents of the file count too.</param>
    public static string Of(Verb verb, BatchJob job)
    {
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        Add(hash, typeof(Fingerprint).Assembly.GetName().Version!.ToString());
        Add(hash, verb.Name);
        Add(hash, job.Output ?? "");
        foreach (var word in job.Words)
        {
            Add(hash, word);
            if (!File.Exists(word)) continue;
            using var file = new FileStream(word, FileMode.Open, FileAccess.Read, FileShare.Read, 1, FileOptions.SequentialScan);
            hash.AppendData(SHA256.HashData(file));
        }
        return Convert.ToHexStringLower(hash.GetHashAndReset().AsSpan(0, 8));
    }

    private static void Add(IncrementalHash hash, string word)
    {
        hash.AppendData(Encoding.UTF8.GetBytes(word));
        hash.AppendData([0]);
    }
}
