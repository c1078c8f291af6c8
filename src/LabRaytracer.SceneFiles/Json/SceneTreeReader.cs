using System.Text;
using System.Text.Json;
using System.Text.Unicode;

namespace LabRaytracer;

/// <summary>Reads JSON (comments and trailing commas allowed) into a tree that keeps the place of every value.</summary>
internal static class SceneTreeReader
{
    /// <summary>Most objects and arrays inside each other.</summary>
    public const int MaxDepth = 64;

    /// <summary>The tree of a file.</summary>
    /// <exception cref="SceneFileException">The file is not UTF-8 text or not JSON, or is nested too deeply.</exception>
    public static SceneTree Read(SceneSource source)
    {
        CheckText(source);
        JsonReaderOptions options = new() { CommentHandling = JsonCommentHandling.Skip, AllowTrailingCommas = true, MaxDepth = MaxDepth + 2 };
        ReadOnlySpan<byte> text = source.Bytes.AsSpan(source.TextStart);
        Utf8JsonReader reader = new(text, options);
        try
        {
            return ReadAll(source, ref reader);
        }
        catch (JsonException failure)
        {
            throw Mistake(source, OffsetOf(source, failure, reader.BytesConsumed), failure);
        }
    }

    private static SceneTree ReadAll(SceneSource source, ref Utf8JsonReader reader)
    {
        List<SceneTree.Entry> entries = [];
        List<SceneFileError> duplicates = [];
        SceneTree tree = new(source, entries, duplicates);
        Stack<(int Index, int Count)> open = new();
        while (reader.Read())
        {
            int offset = source.TextStart + (int)reader.TokenStartIndex;
            if (reader.TokenType is JsonTokenType.EndObject or JsonTokenType.EndArray)
            {
                (int index, int count) = open.Pop();
                entries[index] = entries[index] with { Length = count, Next = entries.Count };
                FindDuplicates(new SceneNode(tree, index), duplicates);
                continue;
            }

            CheckToken(source, ref reader, offset);
            if (open.Count > 0 && (reader.TokenType == JsonTokenType.PropertyName || entries[open.Peek().Index].Kind == NodeKind.Array))
            {
                (int index, int count) = open.Pop();
                open.Push((index, count + 1));
            }

            int length = reader.TokenType is JsonTokenType.PropertyName or JsonTokenType.String ? reader.ValueSpan.Length + 2 : reader.ValueSpan.Length;
            entries.Add(new SceneTree.Entry(offset, length, entries.Count + 1, KindOf(reader.TokenType)));
            if (reader.TokenType is JsonTokenType.StartObject or JsonTokenType.StartArray)
            {
                open.Push((entries.Count - 1, 0));
            }
        }

        return tree;
    }

    private static void FindDuplicates(SceneNode node, List<SceneFileError> duplicates)
    {
        if (node.Kind != NodeKind.Object || node.Count < 2)
        {
            return;
        }

        // The keys of most objects differ in length or first letter; a set of strings is made only of those that do not.
        HashSet<string>? keys = null;
        ulong seen = 0;
        foreach ((SceneNode key, _) in node.Members())
        {
            ulong bit = 1UL << key.QuickHash();
            if ((seen & bit) != 0 && keys is null)
            {
                keys = new HashSet<string>(node.Members().TakeWhile(member => member.Key.Index < key.Index).Select(member => member.Key.Text()), StringComparer.Ordinal);
            }

            seen |= bit;
            if (keys is not null && !keys.Add(key.Text()))
            {
                duplicates.Add(new SceneFileError(key.Location(), $"the key {Wording.Quote(key.Text())} is given twice in one object", "each key once"));
            }
        }
    }

    private static NodeKind KindOf(JsonTokenType token) => token switch
    {
        JsonTokenType.StartObject => NodeKind.Object,
        JsonTokenType.StartArray => NodeKind.Array,
        JsonTokenType.PropertyName or JsonTokenType.String => NodeKind.Text,
        JsonTokenType.Number => NodeKind.Number,
        JsonTokenType.True => NodeKind.True,
        JsonTokenType.False => NodeKind.False,
        _ => NodeKind.Null,
    };

    private static void CheckToken(SceneSource source, ref Utf8JsonReader reader, int offset)
    {
        if (reader.CurrentDepth >= MaxDepth && reader.TokenType is JsonTokenType.StartObject or JsonTokenType.StartArray)
        {
            throw new SceneFileException(new SceneFileError(source.Locate(offset), "objects and arrays are nested too deeply", $"{MaxDepth} levels"));
        }

        if (reader.TokenType is JsonTokenType.PropertyName or JsonTokenType.String && reader.ValueIsEscaped)
        {
            try
            {
                reader.GetString();
            }
            catch (InvalidOperationException failure)
            {
                throw new SceneFileException(
                    new SceneFileError(source.Locate(offset), "the text has half of a surrogate pair (\\ud800 to \\udfff)", "pairs, or the character itself"), failure);
            }
        }
    }

    private static void CheckText(SceneSource source)
    {
        if (!Utf8.IsValid(source.Bytes))
        {
            throw new SceneFileException(new SceneFileError(source.Locate(FirstInvalid(source.Bytes)), "the file is not UTF-8 text", "UTF-8; save the file with this encoding"));
        }
    }

    private static int FirstInvalid(ReadOnlySpan<byte> bytes)
    {
        int at = 0;
        while (at < bytes.Length && Rune.DecodeFromUtf8(bytes[at..], out _, out int length) == System.Buffers.OperationStatus.Done)
        {
            at += length;
        }

        return at;
    }

    // The reader counts lines from 0 and columns in bytes; it knows LF alone as the end of a line.
    private static int OffsetOf(SceneSource source, JsonException failure, long consumed)
    {
        ReadOnlySpan<byte> text = source.Bytes.AsSpan(source.TextStart);
        int start = 0;
        for (long line = failure.LineNumber ?? 0; line > 0 && text[start..].IndexOf((byte)'\n') is var step && step >= 0; line--)
        {
            start += step + 1;
        }

        long offset = failure.LineNumber is null ? consumed : start + (failure.BytePositionInLine ?? 0);
        return source.TextStart + (int)Math.Clamp(offset, 0, text.Length);
    }

    private static SceneFileException Mistake(SceneSource source, int offset, Exception failure)
    {
        ReadOnlySpan<byte> rest = source.Bytes.AsSpan(offset);
        (string what, string? allowed) = rest switch
        {
            [] => ("the file ends too early", "a closed object { ... }"),
            [(byte)'N' or (byte)'I', ..] => ("not a number of JSON", "finite numbers such as 0.5 or 1e-3"),
            [(byte)'\'', ..] => ("texts and keys stand in double quotes", "\"text\""),
            [(byte)'"', ..] => ("unexpected '\"': a comma or colon may be missing before it", null),
            _ => ($"unexpected {Wording.Quote(FirstCharacter(rest))}: the JSON text breaks here", null),
        };
        return new SceneFileException(new SceneFileError(source.Locate(offset), what, allowed), failure);
    }

    private static string FirstCharacter(ReadOnlySpan<byte> text)
    {
        Rune.DecodeFromUtf8(text, out Rune first, out _);
        return first.ToString();
    }
}
