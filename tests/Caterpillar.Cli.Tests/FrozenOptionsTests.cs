using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Caterpillar.Tests;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>
/// Scripts depend on verbs and options: frozen-options.txt lists them. With CATERPILLAR_RENEW=1 new ones are added; one that disappears fails in any case.
/// </summary>
public class FrozenOptionsTests
{
    private static string Listing => Path.Combine(TestData.Repository, "tests", "Caterpillar.Cli.Tests", "frozen-options.txt");

    [Test]
    public void Verbs_and_options_are_those_of_the_list()
    {
        var now = Lines("caterpillar", new GeneralOptions().All)
            .Concat(Verbs.All().SelectMany(v => Lines(string.Join(" ", v.Arguments.Select(a => a.Name).Prepend(v.Name)), v.Options, v.Name))).ToArray();
        var frozen = File.Exists(Listing) ? File.ReadAllLines(Listing) : [];
        Assert.That(frozen.Except(now), Is.Empty, "A verb or an option is gone, or lost a name.");
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1") File.WriteAllText(Listing, string.Join("\n", now) + "\n");
        else Assert.That(now.Except(frozen), Is.Empty, "CATERPILLAR_RENEW=1 adds new ones.");

        static IEnumerable<string> Lines(string usage, IEnumerable<Option> options, string verb = "caterpillar")
            => options.Select(o => $"{verb} {string.Join(" ", o.Aliases.Prepend(o.Name))}").Prepend(usage);
    }

    [TestCaseSource(typeof(SlicerWords), nameof(SlicerWords.Table))]
    public void Answers_to_words_of_other_slicers_are_right((string Words, string Answer) entry)
    {
        if (!entry.Answer.Contains(' '))
        {
            var set = new Machines.ProfileLibrary().Setup("ender3", null, null, [entry.Answer]);
            Assert.That(set.Diagnostics, Is.Empty);
            return;
        }
        var parts = entry.Answer.Split(' ');
        var verbs = Verbs.All().Where(v => parts[0] == "*" || parts[0] == v.Name).ToArray();
        Assert.That(verbs.SelectMany(v => v.Options).Select(o => o.Name), Does.Contain(parts[1]));
    }
}
