using System.Globalization;
using System.Text;

namespace LabRaytracer;

/// <summary>The values of a JSON file as one flat list: each is followed by what it holds.</summary>
/// <remarks>16 bytes a value; texts and numbers stay in the bytes of the file until they are asked for.</remarks>
internal sealed class SceneTree
{
    public SceneTree(SceneSource source, List<Entry> entries, IReadOnlyList<SceneFileError> mistakes)
    {
        Source = source;
        Entries = entries;
        Mistakes = mistakes;
    }

    public SceneSource Source { get; }

    public List<Entry> Entries { get; }

    /// <summary>Mistakes that leave a tree to go on with: keys given twice.</summary>
    public IReadOnlyList<SceneFileError> Mistakes { get; }

    public SceneNode Root => new(this, 0);

    /// <summary>The way from the root to a value: objects[3].center[0].</summary>
    public string PathTo(int index)
    {
        StringBuilder path = new();
        SceneNode node = Root;
        while (node.Index < index)
        {
            node = Descend(node, index, path);
        }

        return path.ToString();
    }

    private static SceneNode Descend(SceneNode node, int index, StringBuilder path)
    {
        SceneNode last = default;
        string step = "";
        if (node.Kind == NodeKind.Array)
        {
            int number = 0;
            foreach (SceneNode item in node.Items().TakeWhile(item => item.Index <= index))
            {
                last = item;
                step = string.Create(CultureInfo.InvariantCulture, $"[{number++}]");
            }
        }
        else
        {
            SceneNode name = default;
            foreach ((SceneNode key, SceneNode value) in node.Members().TakeWhile(member => member.Key.Index <= index))
            {
                (name, last) = (key, value);
            }

            step = (path.Length > 0 ? "." : "") + Wording.Name(name.Text());
            last = name.Index == index ? name : last;
        }

        path.Append(step);
        return last;
    }

    /// <summary>One value: where it is in the file and in the list.</summary>
    /// <param name="Offset">Offset of the first byte.</param>
    /// <param name="Length">Bytes of a text or number; items of an array; members of an object.</param>
    /// <param name="Next">Index after this value and all that it holds.</param>
    /// <param name="Kind">What it is.</param>
    public readonly record struct Entry(int Offset, int Length, int Next, NodeKind Kind);
}
