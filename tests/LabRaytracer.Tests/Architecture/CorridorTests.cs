using System.Text.RegularExpressions;

namespace LabRaytracer.Tests.Architecture;

/// <summary>The rooms (folders) of the library lie along a corridor: each uses only what was declared before it.</summary>
public sealed partial class CorridorTests
{
    private const string Library = "src/LabRaytracer";

    private static readonly string[] s_rooms =
        ["Numerics", "Imaging", "Cameras", "Mapping", "Geometry", "Texturing", "Materials", "Lighting", "Scenes", "Rendering"];

    [Fact]
    public void Rooms_AreTheseAndNoOthers() =>
        Assert.Equal(s_rooms.Order(StringComparer.Ordinal), SourceTree.Files(Library).Select(Room).Distinct().Order(StringComparer.Ordinal));

    [Fact]
    public void EveryFile_UsesOnlyRoomsBeforeItsOwn()
    {
        Dictionary<string, int> firstRoom = [];
        foreach (string file in SourceTree.Files(Library))
        {
            foreach (Match declared in Declarations().Matches(SourceTree.Code(file)))
            {
                int room = Array.IndexOf(s_rooms, Room(file));
                string name = declared.Groups[1].Value;
                firstRoom[name] = Math.Min(room, firstRoom.GetValueOrDefault(name, room));
            }
        }

        Assert.Empty(SourceTree.Files(Library).SelectMany(file => Trespasses(file, firstRoom)));
    }

    [Fact]
    public void ACallIntoALaterRoom_IsFound()
    {
        Dictionary<string, int> rooms = new() { ["Ray"] = 0, ["Renderer"] = 9, ["Fresnel"] = 9 };
        Assert.Equal(["Renderer"], Later("internal sealed class Odd { Ray ray; void Run() => Renderer.Render(); int Fresnel { get; } int x = Own.Renderer; }", 4, rooms));
    }

    private static IEnumerable<string> Trespasses(string file, Dictionary<string, int> firstRoom) =>
        Later(SourceTree.Code(file), Array.IndexOf(s_rooms, Room(file)), firstRoom)
            .Select(name => $"{file} uses {name} of the later room {s_rooms[firstRoom[name]]}.");

    /// <summary>Names of later rooms' types in a code; names of the code's own properties and constants do not count.</summary>
    private static IEnumerable<string> Later(string code, int room, Dictionary<string, int> firstRoom)
    {
        HashSet<string> members = [.. Members().Matches(code).Select(match => match.Groups[1].Value)];
        return Names().Matches(code).Select(match => match.Value).Distinct()
            .Where(name => firstRoom.TryGetValue(name, out int declared) && declared > room && !members.Contains(name));
    }

    private static string Room(string file) => file[(Library.Length + 1)..].Split('/')[0];

    [GeneratedRegex(@"\b(?:class|struct|interface|enum|record(?:\s+struct|\s+class)?)\s+([A-Z]\w*)")]
    private static partial Regex Declarations();

    [GeneratedRegex(@"(?<![.\w])[A-Z]\w*\b")]
    private static partial Regex Names();

    [GeneratedRegex(@"\b([A-Z]\w*)\s*(?:\{\s*get\b|=>|=(?!=))")]
    private static partial Regex Members();
}
