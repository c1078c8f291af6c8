using System.Buffers;

namespace LabRaytracer;

/// <summary>How many elements a part of an OBJ file has.</summary>
/// <param name="Positions">Lines v.</param>
/// <param name="Uvs">Lines vt.</param>
/// <param name="Normals">Lines vn.</param>
/// <param name="Triangles">Triangles of the lines f: corners minus two of each.</param>
internal readonly record struct ObjCounts(int Positions, int Uvs, int Normals, int Triangles)
{
    private static readonly SearchValues<byte> s_plain = SearchValues.Create("0123456789/- "u8);

    public static ObjCounts operator +(ObjCounts a, ObjCounts b) => new(
        checked(a.Positions + b.Positions), checked(a.Uvs + b.Uvs), checked(a.Normals + b.Normals), checked(a.Triangles + b.Triangles));

    /// <summary>Counts the elements of whole lines.</summary>
    /// <param name="bytes">The whole file.</param>
    /// <param name="start">Offset of the first line.</param>
    /// <param name="end">Offset after the last.</param>
    public static ObjCounts Of(ReadOnlySpan<byte> bytes, int start, int end)
    {
        int positions = 0, uvs = 0, normals = 0, triangles = 0;
        for (int at = start; at < end;)
        {
            LineText line = new(bytes, at);
            at = line.Next;
            switch (ObjWords.KindOf(line.Word()))
            {
                case ObjWord.Position:
                    positions++;
                    break;
                case ObjWord.Uv:
                    uvs++;
                    break;
                case ObjWord.Normal:
                    normals++;
                    break;
                case ObjWord.Face:
                    triangles += CountTriangles(ref line);
                    break;
            }
        }

        return new ObjCounts(positions, uvs, normals, triangles);
    }

    private static int CountTriangles(ref LineText line)
    {
        // Between single spaces and nothing that separates words otherwise, there is a corner after each space.
        ReadOnlySpan<byte> text = line.Ahead;
        if (text.IndexOfAnyExcept(s_plain) < 0 && text.IndexOf("  "u8) < 0 && !text.EndsWith((byte)' '))
        {
            return Math.Max(0, text.Count((byte)' ') - 2);
        }

        int corners = 0;
        while (line.ToWord())
        {
            corners++;
            line.SkipWord();
        }

        return Math.Max(0, corners - 2);
    }
}
