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
    public void Properties_RefuseNullAndUnknownEnumValues()
    {
        NullabilityInfoContext nullability = new();
        int tried = 0;
        foreach (object target in Specimens())
        {
            foreach (PropertyInfo property in target.GetType().GetProperties().Where(property => property.SetMethod is { IsPublic: true }))
            {
                Type type = Nullable.GetUnderlyingType(property.PropertyType) ?? property.PropertyType;
                bool takesNull = nullability.Create(property).WriteState == NullabilityState.Nullable;
                if (type.IsEnum && type.GetCustomAttribute<FlagsAttribute>() is null)
                {
                    tried++;
                    Assert.IsType<ArgumentOutOfRangeException>(Refusal(property, target, Enum.ToObject(type, 99)));
                }
                else if (!type.IsValueType && type != typeof(string) && !takesNull)
                {
                    tried++;
                    Assert.IsType<ArgumentNullException>(Refusal(property, target, null));
                }
            }
        }

        Assert.InRange(tried, 30, 200);
    }

    /// <summary>An object of every public class that can be made without arguments, and of some that cannot.</summary>
    private static IEnumerable<object> Specimens() => PublicTypes
        .Where(type => type is { IsClass: true, IsAbstract: false } && type.GetConstructor([]) is not null)
        .Select(type => Activator.CreateInstance(type)!)
        .Append(new Texture(1, 1))
        .Append(new PointLight(Point3D.Origin, Intensity.White))
        .Append(new SpotLight(Point3D.Origin, new Point3D(0, 0, 1), Intensity.White, 20, 10));

    private static Exception? Refusal(PropertyInfo property, object target, object? value)
    {
        try
        {
            property.SetValue(target, value);
        }
        catch (TargetInvocationException refusal)
        {
            return refusal.InnerException;
        }

        Assert.Fail($"{property.DeclaringType!.Name}.{property.Name} takes {value ?? "null"}.");
        return null;
    }

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
