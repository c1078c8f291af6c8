using System.Reflection;
using System.Runtime.CompilerServices;
using System.Xml.Linq;

namespace LabRaytracer.Tests.Architecture;

/// <summary>What every public type keeps to.</summary>
public sealed class PublicTypeTests
{
    private static readonly Assembly[] s_libraries = [typeof(Texture).Assembly, typeof(SceneFile).Assembly];

    private static IEnumerable<Type> PublicTypes => s_libraries.SelectMany(library => library.GetExportedTypes());

    [Fact]
    public void Namespace_IsOne() => Assert.All(PublicTypes, type => Assert.Equal("LabRaytracer", type.Namespace));

    [Fact]
    public void Classes_AreSealedOrAbstract() => Assert.Empty(PublicTypes.Where(type => type.IsClass && !type.IsSealed && !type.IsAbstract).Select(type => type.Name));

    [Fact]
    public void Structs_AreReadonly() => Assert.Empty(
        PublicTypes.Where(type => type.IsValueType && !type.IsEnum && type.GetCustomAttribute<IsReadOnlyAttribute>() is null).Select(type => type.Name));

    [Fact]
    public void Fields_AreConstant() => Assert.Empty(
        PublicTypes.Where(type => !type.IsEnum)
            .SelectMany(type => type.GetFields(BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly))
            .Where(field => !field.IsLiteral && !field.IsInitOnly)
            .Select(field => $"{field.DeclaringType!.Name}.{field.Name}"));

    [Fact]
    public void Methods_TakeNoBool() => Assert.Empty(
        PublicTypes.Where(type => !typeof(MulticastDelegate).IsAssignableFrom(type))
            .SelectMany(type => type.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly))
            .Where(method => !method.IsSpecialName && method.GetParameters().Any(parameter => parameter.ParameterType == typeof(bool)))
            .Select(method => $"{method.DeclaringType!.Name}.{method.Name}"));

    [Fact]
    public void EveryPublicType_IsDocumented()
    {
        foreach (Assembly library in s_libraries)
        {
            XDocument docs = XDocument.Load(Path.ChangeExtension(library.Location, ".xml"));
            Dictionary<string, string> summaries = docs.Descendants("member")
                .ToDictionary(member => member.Attribute("name")!.Value, member => member.Element("summary")?.Value.Trim() ?? "");
            Assert.Empty(library.GetExportedTypes()
                .Select(type => "T:" + type.FullName!.Replace('+', '.'))
                .Where(name => summaries.GetValueOrDefault(name, "").Length == 0)
                .Order(StringComparer.Ordinal));
        }
    }
}
