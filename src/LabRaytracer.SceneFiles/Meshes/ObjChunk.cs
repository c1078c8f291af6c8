using System.Text;

namespace LabRaytracer;

/// <summary>Reads some lines of an OBJ file into the arrays of the whole; other threads read the other lines.</summary>
internal sealed class ObjChunk(SceneSource source, ObjData data, int start, int end, ObjCounts before)
{
    private const int MostMistakes = 100;

    // What a mesh takes; beyond it, products of coordinates leave the floats of its boxes.
    private const double LargestNumber = 1e18;

    // No index was written; 0 is one that was, and wrong.
    private const int None = int.MinValue;


    // Faces with four corners or more: first triangle of the fan, number of corners, place.
    private readonly List<(int Triangle, int Corners, int Offset)> _polygons = [];

    // Indices from the end count from the elements so far.
    private int _positions = before.Positions, _uvs = before.Uvs, _normals = before.Normals, _triangles = before.Triangles;

    /// <summary>Lines usemtl: the first triangle that they are for, the name, where it stands.</summary>
    public List<(int Triangle, string Name, int Offset)> Materials { get; } = [];

    /// <summary>Lines mtllib.</summary>
    public List<(string Name, int Offset)> Libraries { get; } = [];


    public List<SceneFileError> Mistakes { get; } = [];

    /// <summary>Reads the lines.</summary>
    public void Read()
    {
        for (int at = start; at < end;)
        {
            at = ReadQuickly(at);
            if (at >= end)
            {
                break;
            }

            LineText line = new(source.Bytes, at);
            at = line.Next;
            line.ToWord();
            int first = line.Position;
            ReadOnlySpan<byte> word = line.Word();
            switch (ObjWords.KindOf(word))
            {
                case ObjWord.Position:
                    ReadPosition(ref line);
                    break;
                case ObjWord.Uv:
                    ReadUv(ref line);
                    break;
                case ObjWord.Normal:
                    ReadNormal(ref line);
                    break;
                case ObjWord.Face:
                    ReadFace(ref line, first);
                    break;
                case ObjWord.UseMaterial:
                    line.ToWord();
                    Materials.Add((_triangles, Encoding.UTF8.GetString(line.Rest()), first));
                    break;
                case ObjWord.Library:
                    line.ToWord();
                    Libraries.Add((Encoding.UTF8.GetString(line.Rest()), first));
                    break;
                case ObjWord.Unknown:
                    Mistake(first, $"unknown word {Wording.Quote(Encoding.UTF8.GetString(word))}", ObjWords.Allowed);
                    break;
            }
        }
    }

    /// <summary>Reads lines as long as they are simple; returns where the first one starts that is not.</summary>
    private unsafe int ReadQuickly(int from)
    {
        Span<ObjCorner> corners = stackalloc ObjCorner[3];
        fixed (byte* bytes = source.Bytes)
        {
            byte* at = bytes + from, last = bytes + Math.Min(end, source.Bytes.Length - ObjQuick.LongestLine);
            while (at < last)
            {
                byte* next = (*at, at[1]) switch
                {
                    ((byte)'v', (byte)' ') => ObjQuick.Numbers(at + 2, data.Positions.AsSpan(3 * _positions, 3)),
                    ((byte)'v', (byte)'n') when at[2] == ' ' => ObjQuick.Numbers(at + 3, data.Normals.AsSpan(3 * _normals, 3)),
                    ((byte)'v', (byte)'t') when at[2] == ' ' => ObjQuick.Numbers(at + 3, data.Uvs.AsSpan(2 * _uvs, 2)),
                    ((byte)'f', (byte)' ') => ObjQuick.Face(at + 2, data.Counts, corners),
                    _ => null,
                };
                if (next == null)
                {
                    break;
                }

                Count(*at, at[1], corners);
                at = next;
            }

            return (int)(at - bytes);
        }
    }

    private void Count(byte first, byte second, ReadOnlySpan<ObjCorner> corners)
    {
        if (first == 'f')
        {
            int at = 3 * _triangles++;
            data.SetCorner(at, corners[0]);
            data.SetCorner(at + 1, corners[1]);
            data.SetCorner(at + 2, corners[2]);
        }
        else
        {
            _positions += second == ' ' ? 1 : 0;
            _normals += second == 'n' ? 1 : 0;
            _uvs += second == 't' ? 1 : 0;
        }
    }

    /// <summary>Cuts faces with four corners or more into triangles; all positions must have been read, without mistakes.</summary>
    public void SplitPolygons()
    {
        foreach ((int triangle, int corners, int offset) in _polygons)
        {
            if (!PolygonSplitter.TrySplit(data, triangle, corners))
            {
                Mistake(offset, $"a concave face with {corners} corners", $"concave faces with up to {PolygonSplitter.MostCorners} corners");
            }
        }
    }

    // Weights and colours that some programs write after x, y, z are not needed.
    private void ReadPosition(ref LineText line)
    {
        bool good = line.TryNumber(out double x) & line.TryNumber(out double y) & line.TryNumber(out double z);
        int at = 3 * _positions++;
        (data.Positions[at], data.Positions[at + 1], data.Positions[at + 2]) = (x, y, z);
        MistakeUnless(good && Math.Max(Math.Abs(x), Math.Max(Math.Abs(y), Math.Abs(z))) <= LargestNumber, ref line, "v with three numbers x y z up to 1e18");
    }

    private void ReadNormal(ref LineText line)
    {
        bool good = line.TryNumber(out double x) & line.TryNumber(out double y) & line.TryNumber(out double z);
        int at = 3 * _normals++;
        (data.Normals[at], data.Normals[at + 1], data.Normals[at + 2]) = (x, y, z);
        MistakeUnless(good && Math.Max(Math.Abs(x), Math.Max(Math.Abs(y), Math.Abs(z))) <= LargestNumber, ref line, "vn with three numbers x y z up to 1e18");
    }

    private void ReadUv(ref LineText line)
    {
        bool good = line.TryNumber(out double u);
        double v = 0;
        good = good && (!line.ToWord() || line.TryNumber(out v));
        int at = 2 * _uvs++;
        (data.Uvs[at], data.Uvs[at + 1]) = (u, v);
        MistakeUnless(good, ref line, "vt with one to three finite numbers u v w");
    }

    private void ReadFace(ref LineText line, int first)
    {
        int corners = 0, fan = _triangles;
        ObjCorner hub = default, last = default;
        while (line.ToWord())
        {
            ObjCorner corner = ReadCorner(ref line);
            if (corners == 0)
            {
                hub = corner;
            }
            else if (corners > 1)
            {
                int at = 3 * _triangles++;
                data.SetCorner(at, hub);
                data.SetCorner(at + 1, last);
                data.SetCorner(at + 2, corner);
            }

            last = corner;
            corners++;
        }

        if (corners > 3)
        {
            _polygons.Add((fan, corners, first));
        }
        else if (corners < 3)
        {
            Mistake(first, $"a face with {corners} corner{(corners == 1 ? "" : "s")}", "f with three corners or more");
        }
    }

    private ObjCorner ReadCorner(ref LineText line)
    {
        int start = line.Position;
        bool good = line.TryIndex(out int position);
        int uv = None, normal = None;
        if (good && line.TrySlash())
        {
            LineText ahead = line;
            bool empty = ahead.TrySlash();
            good = empty || line.TryIndex(out uv);
            if (good && line.TrySlash())
            {
                good = line.TryIndex(out normal);
            }
        }

        if (!good || !line.AtWordEnd)
        {
            line.SkipWord();
            string word = Encoding.UTF8.GetString(source.Bytes.AsSpan(start, line.Position - start));
            Mistake(start, $"{Wording.Quote(word)} is not a corner of a face", "v, v/vt, v//vn, v/vt/vn");
            return default;
        }

        return new ObjCorner(
            Resolve(position, _positions, data.Counts.Positions, start, "v"),
            uv == None ? -1 : Resolve(uv, _uvs, data.Counts.Uvs, start, "vt"),
            normal == None ? -1 : Resolve(normal, _normals, data.Counts.Normals, start, "vn"));
    }

    private int Resolve(int index, int soFar, int all, int offset, string word)
    {
        int resolved = index > 0 ? index - 1 : soFar + index;
        if (index != 0 && resolved >= 0 && resolved < all)
        {
            return resolved;
        }

        string allowed = all == 0 ? $"none, there is no {word}" : $"1 to {all}, or -1 to -{Math.Max(soFar, 1)}";
        Mistake(offset, $"there is no {word} with the index {index}", allowed);
        return 0;
    }

    private void MistakeUnless(bool good, ref LineText line, string allowed)
    {
        if (!good)
        {
            line.ToWord();
            Mistake(Math.Min(line.Position, line.End), line.Describe(), allowed);
        }
    }

    private void Mistake(int offset, string what, string allowed)
    {
        if (Mistakes.Count < MostMistakes)
        {
            Mistakes.Add(new SceneFileError(source.Locate(offset), what, allowed));
        }
    }
}
