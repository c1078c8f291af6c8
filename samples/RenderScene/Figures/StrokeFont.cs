namespace RenderScene;

/// <summary>Letters as lines on a grid of 5 x 9 points: enough for the labels of figures.</summary>
internal static class StrokeFont
{
    /// <summary>Height from the baseline to the top of capitals and digits, grid units.</summary>
    public const double CapHeight = 6;

    /// <summary>From one letter to the next, grid units.</summary>
    public const double Advance = 6;

    private const double Baseline = 2;

    // Each pair of digits is a point: column 0..4, row 0..8 with the baseline at 2. A space lifts the pen.
    private static readonly Dictionary<char, string> s_letters = new()
    {
        ['a'] = "4642 4536160503123243", ['b'] = "0802 0516364543321203", ['c'] = "4536160503123243", ['d'] = "4842 4536160503123243",
        ['e'] = "04444536160503123243", ['f'] = "38281712 0626", ['g'] = "4641301001 4536160503123243", ['h'] = "0802 0516364542",
        ['i'] = "2622 2828", ['j'] = "26211000 2828", ['k'] = "0802 4604 1442", ['l'] = "182322 2332", ['m'] = "0602 05162522 25364542",
        ['n'] = "0602 0516364542", ['o'] = "160503123243453616", ['p'] = "0600 0516364543321203", ['q'] = "4640 4536160503123243",
        ['r'] = "0602 041636", ['s'] = "45361605143443321203", ['t'] = "18132232 0636", ['u'] = "0603123243 4642", ['v'] = "062246",
        ['w'] = "0612253246", ['x'] = "0642 4602", ['y'] = "0622 4610", ['z'] = "06460242",
        ['0'] = "180703123243473818", ['1'] = "172822 1232", ['2'] = "07183847460242", ['3'] = "07183847463515 354443321203", ['4'] = "380444 3832",
        ['5'] = "480805354443321203", ['6'] = "473818070312324344351504", ['7'] = "084812", ['8'] = "15060718384746351504031232434435",
        ['9'] = "031232434738180706153546", ['\u03c6'] = "160503123243453616 2820", ['\u03b8'] = "180703123243473818 0545", ['\u03c0'] = "0646 1612 363342",
        ['('] = "38272332", [')'] = "18272312", [','] = "2211", ['.'] = "2222", ['='] = "0545 0343", ['/'] = "4802", ['-'] = "0444", ['+'] = "0444 2622", ['>'] = "064402", [':'] = "2525 2222",
    };

    /// <summary>The lines of a text, in grid units from the left end of its baseline, y up. An underscore lowers and shrinks the letter after it.</summary>
    /// <exception cref="ArgumentException">A letter is not in the font.</exception>
    public static IEnumerable<(double X0, double Y0, double X1, double Y1)> Lines(string text)
    {
        double left = 0;
        bool isLow = false;
        foreach (char letter in text)
        {
            if (letter == '_')
            {
                isLow = true;
                continue;
            }

            double scale = isLow ? 0.65 : 1, bottom = isLow ? -1.5 : 0;
            foreach ((double x0, double y0, double x1, double y1) in Lines(letter))
            {
                yield return (left + (scale * x0), bottom + (scale * y0), left + (scale * x1), bottom + (scale * y1));
            }

            left += scale * Advance;
            isLow = false;
        }
    }

    /// <summary>Width of a text, grid units.</summary>
    public static double Width(string text)
    {
        int low = text.Count(letter => letter == '_');
        return ((text.Length - (2 * low)) * Advance) + (low * 0.65 * Advance) - 2;
    }

    private static IEnumerable<(double X0, double Y0, double X1, double Y1)> Lines(char letter)
    {
        if (letter == ' ')
        {
            yield break;
        }

        if (!s_letters.TryGetValue(letter, out string? strokes))
        {
            throw new ArgumentException($"The font of the figures has no letter '{letter}'.", nameof(letter));
        }

        foreach (string stroke in strokes.Split(' '))
        {
            for (int i = 0; i + 3 < stroke.Length; i += 2)
            {
                yield return (stroke[i] - '0', stroke[i + 1] - '0' - Baseline, stroke[i + 2] - '0', stroke[i + 3] - '0' - Baseline);
            }
        }
    }
}
