using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Small signs of 9 x 9 dots: the numbers 0 to 99, an arrow that points up, a letter R.</summary>
internal static unsafe class GridGlyphs
{
    /// <summary>Dots along a side.</summary>
    public const int Side = 9;

    /// <summary>Dots of a sign.</summary>
    public const int Area = Side * Side;

    /// <summary>Number of the arrow; the numbers 0 to 99 come before it, the R after it.</summary>
    public const int Arrow = 100;

    private const int Count = Arrow + 2;

    private static readonly string[] s_arrow =
    [
        ".........",
        "....#....",
        "...###...",
        "..#####..",
        ".#######.",
        "....#....",
        "....#....",
        "....#....",
        ".........",
    ];

    private static readonly string[] s_letter =
    [
        ".........",
        "..####...",
        "..#...#..",
        "..#...#..",
        "..####...",
        "..#.#....",
        "..#..#...",
        "..#...#..",
        ".........",
    ];

    private static readonly int[] s_dots = Build();

    /// <summary>1 for ink, 0 for paper: sign by sign, each row by row from the bottom, which is where v starts.</summary>
    public static int* Dots => (int*)Marshal.UnsafeAddrOfPinnedArrayElement(s_dots, 0);

    // Digits of 3 x 5 dots: the top row is written first, three bits a row, the left dot highest.
    private static ReadOnlySpan<ushort> Digits =>
    [
        0b_111_101_101_101_111, 0b_010_110_010_010_111, 0b_111_001_111_100_111, 0b_111_001_111_001_111, 0b_101_101_111_001_001,
        0b_111_100_111_001_111, 0b_111_100_111_101_111, 0b_111_001_010_010_010, 0b_111_101_111_101_111, 0b_111_101_111_001_111,
    ];

    private static int[] Build()
    {
        int[] dots = GC.AllocateArray<int>(Count * Area, pinned: true);
        for (int number = 0; number < Arrow; number++)
        {
            Span<int> sign = dots.AsSpan(number * Area, Area);
            DrawDigit(sign, number < 10 ? 3 : 5, Digits[number % 10]);
            if (number >= 10)
            {
                DrawDigit(sign, 1, Digits[number / 10]);
            }
        }

        Draw(dots.AsSpan(Arrow * Area, Area), s_arrow);
        Draw(dots.AsSpan((Arrow + 1) * Area, Area), s_letter);
        return dots;
    }

    private static void DrawDigit(Span<int> sign, int left, int digit)
    {
        for (int bit = 0; bit < 15; bit++)
        {
            sign[((2 + (bit / 3)) * Side) + left + 2 - (bit % 3)] = (digit >> bit) & 1;
        }
    }

    private static void Draw(Span<int> sign, string[] rows)
    {
        for (int y = 0; y < Side; y++)
        {
            for (int x = 0; x < Side; x++)
            {
                sign[((Side - 1 - y) * Side) + x] = rows[y][x] == '#' ? 1 : 0;
            }
        }
    }
}
