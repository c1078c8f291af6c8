namespace LabRaytracer;

/// <summary>Reads lines of OBJ files that are written the way programs write them: single spaces, plain numbers, triangles. Other lines are left to <see cref="ObjChunk"/>.</summary>
/// <remarks>No place in a line is tested for the end of the file: callers see to it that <see cref="LongestLine"/> bytes follow.</remarks>
internal static unsafe class ObjQuick
{
    /// <summary>No line that is read here has more bytes, its end included: three corners of three signed 10-digit numbers and what separates them.</summary>
    public const int LongestLine = 128;

    // Numbers of so many digits are exact in a double, and so are the powers of ten that scale them: one division rounds once.
    private const int MostDigits = 15;
    private const int MostIndexDigits = 9;

    private static readonly double[] s_powers = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

    /// <summary>Reads numbers to the end of the line.</summary>
    /// <param name="at">The first byte of the first number.</param>
    /// <param name="numbers">Where they go; as many as there must be.</param>
    /// <returns>The byte after the line, or null if it is not read here.</returns>
    public static byte* Numbers(byte* at, Span<double> numbers)
    {
        for (int i = 0; i < numbers.Length; i++)
        {
            if (i > 0 && *at++ != ' ')
            {
                return null;
            }

            at = Number(at, out numbers[i]);
            if (at == null)
            {
                return null;
            }
        }

        return AfterEnd(at);
    }

    /// <summary>Reads three corners to the end of the line, each v, v/vt, v//vn or v/vt/vn with positive numbers.</summary>
    /// <param name="at">The first byte of the first corner.</param>
    /// <param name="counts">How many elements there are.</param>
    /// <param name="corners">The corners, numbered from 0; -1 for none.</param>
    /// <returns>The byte after the line, or null if it is not read here.</returns>
    public static byte* Face(byte* at, in ObjCounts counts, Span<ObjCorner> corners)
    {
        for (int i = 0; i < 3; i++)
        {
            if (i > 0 && *at++ != ' ')
            {
                return null;
            }

            at = Index(at, counts.Positions, out int position);
            int uv = -1, normal = -1;
            if (at != null && *at == '/')
            {
                at = at[1] == '/' ? at + 1 : Index(at + 1, counts.Uvs, out uv);
                if (at != null && *at == '/')
                {
                    at = Index(at + 1, counts.Normals, out normal);
                }
            }

            if (at == null)
            {
                return null;
            }

            corners[i] = new ObjCorner(position, uv, normal);
        }

        return AfterEnd(at);
    }

    private static byte* Number(byte* at, out double value)
    {
        bool isNegative = *at == '-';
        at += isNegative ? 1 : 0;
        byte* start = at;
        ulong digits = 0;
        uint digit;
        while ((digit = (uint)(*at - '0')) <= 9)
        {
            digits = (digits * 10) + digit;
            at++;
            if (at - start > MostDigits)
            {
                break;
            }
        }

        long count = at - start, decimals = 0;
        if (*at == '.')
        {
            byte* point = ++at;
            while ((digit = (uint)(*at - '0')) <= 9 && count + (at - point) <= MostDigits)
            {
                digits = (digits * 10) + digit;
                at++;
            }

            decimals = at - point;
            count += decimals;
        }

        if (count is 0 or > MostDigits)
        {
            value = 0;
            return null;
        }

        value = decimals == 0 ? digits : digits / s_powers[decimals];
        value = isNegative ? -value : value;
        return at;
    }

    /// <summary>Reads a number of [1, count] as [0, count).</summary>
    private static byte* Index(byte* at, int count, out int index)
    {
        byte* start = at;
        uint number = 0, digit;
        while ((digit = (uint)(*at - '0')) <= 9 && at - start < MostIndexDigits)
        {
            number = (number * 10) + digit;
            at++;
        }

        index = (int)number - 1;
        return number != 0 && number <= (uint)count ? at : null;
    }

    /// <summary>The byte after the end of the line, if it is here.</summary>
    private static byte* AfterEnd(byte* at) => *at == '\n' ? at + 1 : *at == '\r' && at[1] == '\n' ? at + 2 : null;
}
