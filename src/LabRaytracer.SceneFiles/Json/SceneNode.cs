using System.Globalization;
using System.Text;
using System.Text.Json;

namespace LabRaytracer;

/// <summary>A value of a JSON file that knows its place.</summary>
internal readonly struct SceneNode
{
    private readonly SceneTree _tree;
    private readonly int _index;

    public SceneNode(SceneTree tree, int index)
    {
        _tree = tree;
        _index = index;
    }

    public NodeKind Kind => Entry.Kind;

    /// <summary>Offset of the first byte.</summary>
    public int Offset => Entry.Offset;

    /// <summary>Number of items of an array, or of members of an object.</summary>
    public int Count => Entry.Length;

    /// <summary>Position in the tree; grows in the order of the file.</summary>
    public int Index => _index;

    private SceneTree.Entry Entry => _tree.Entries[_index];

    private ReadOnlySpan<byte> Raw => _tree.Source.Bytes.AsSpan(Entry.Offset, Entry.Length);

    /// <summary>The items of an array.</summary>
    public IEnumerable<SceneNode> Items()
    {
        int next = _index + 1;
        for (int i = 0; i < Count; i++)
        {
            yield return new SceneNode(_tree, next);
            next = _tree.Entries[next].Next;
        }
    }

    /// <summary>The members of an object, in the order of the file.</summary>
    public IEnumerable<(SceneNode Key, SceneNode Value)> Members()
    {
        int next = _index + 1;
        for (int i = 0; i < Count; i++)
        {
            yield return (new SceneNode(_tree, next), new SceneNode(_tree, next + 1));
            next = _tree.Entries[next + 1].Next;
        }
    }

    /// <summary>The characters of a text, without quotes and escapes.</summary>
    public string Text()
    {
        ReadOnlySpan<byte> raw = Raw;
        if (!raw.Contains((byte)'\\'))
        {
            return Encoding.UTF8.GetString(raw[1..^1]);
        }

        Utf8JsonReader reader = new(raw);
        reader.Read();
        return reader.GetString()!;
    }

    /// <summary>Tells whether the text is the same as another, without making a string where it has no escapes.</summary>
    public bool TextIs(string other)
    {
        ReadOnlySpan<byte> raw = Raw;
        return raw.Contains((byte)'\\') ? Text() == other : raw.Length == other.Length + 2 && Ascii.Equals(raw[1..^1], other);
    }

    /// <summary>A number in [0, 63] that is the same for the same text.</summary>
    public int QuickHash()
    {
        ReadOnlySpan<byte> raw = Raw;
        ReadOnlySpan<byte> text = raw.Contains((byte)'\\') ? Encoding.UTF8.GetBytes(Text()) : raw[1..^1];
        int hash = 0;
        foreach (byte b in text)
        {
            hash = (hash * 31) + b;
        }

        return hash & 63;
    }

    /// <summary>A number as it stands in the file.</summary>
    public string NumberText() => Encoding.ASCII.GetString(Raw);

    /// <summary>The double nearest to a number; false if it is beyond the doubles: too large, or so small that only 0 is left.</summary>
    public bool TryNumber(out double value)
    {
        ReadOnlySpan<byte> raw = Raw;
        value = double.Parse(raw, NumberStyles.Float, CultureInfo.InvariantCulture);
        if (value != 0 || raw.Length == 1)
        {
            return double.IsFinite(value);
        }

        int exponent = raw.IndexOfAny((byte)'e', (byte)'E');
        return !(exponent < 0 ? raw : raw[..exponent]).ContainsAnyInRange((byte)'1', (byte)'9');
    }

    /// <summary>Where the value starts.</summary>
    public SceneLocation Location() => _tree.Source.Locate(Offset);

    /// <summary>The way from the root: objects[3].center[0]; empty for the root itself.</summary>
    public string Path() => _tree.PathTo(_index);
}
