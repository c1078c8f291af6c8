namespace LabRaytracer;

/// <summary>A scene frozen for rendering: shapes packed by class, materials reduced to needs, textures ready.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <remarks>Immutable after construction, thread safe.</remarks>
internal sealed unsafe class CompiledScene<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly LaneMemory _memory = new();
    private readonly List<ShapeGroup<R, F, I>> _groups = [];
    private readonly int* _memberOfObject;
    private readonly int* _keyOfObject;
    private readonly SceneBvh<R, F, I> _all;
    private readonly SceneBvh<R, F, I> _casters;

    /// <summary>Freezes a scene.</summary>
    /// <param name="scene">The scene; it must not be edited while this object is in use.</param>
    /// <param name="filter">Filter of all picture textures, or null for their own.</param>
    /// <param name="threads">Threads for preparing, at least 1.</param>
    /// <param name="isSkipping">Whether work that cannot change the picture is left out.</param>
    public CompiledScene(Scene scene, TextureFilter? filter, int threads, bool isSkipping = true)
    {
        Camera = scene.Camera;
        IsSkipping = isSkipping;
        HashSet<TriangleMesh> meshes = StartTrees(scene, threads);
        Textures = new TexturePreparation(filter);
        ITexture[] used = [.. SceneTextures.Used(scene).Select(use => use.Texture).Distinct()], unused = [.. SceneTextures.Named(scene).Except(used)];
        Textures.PrepareAll(SceneTextures.Used(scene), threads);
        TexturesSkipped = isSkipping ? unused.Length : 0;
        if (!isSkipping)
        {
            Textures.PrepareAll(unused.Select(texture => (texture, TextureUse.Color)), threads);
        }

        Background = Sky(scene.Background);
        BackgroundRotation = scene.BackgroundRotation;
        List<SceneObject> objects = [.. scene.Objects, .. VisibleLamps.Of(scene)];
        int count = objects.Count;
        _memberOfObject = _memory.Column<int>(Math.Max(1, count), 1);
        _keyOfObject = _memory.Column<int>(Math.Max(1, count), 1);
        List<ObjectEntry<R, F, I>> entries = Pack(objects);
        foreach (ShapeGroup<R, F, I> group in _groups)
        {
            group.Freeze(_memory, threads);
        }

        List<ObjectEntry<R, F, I>> opaque = [.. entries.Where(entry => !HasOpacity(entry))], alpha = [.. entries.Where(HasOpacity)];
        bool Casts(ObjectEntry<R, F, I> entry) => objects[entry.Number].CastsShadows;
        _all = Search(opaque, threads);
        _casters = opaque.All(Casts) ? _all : Search([.. opaque.Where(Casts)], threads);
        AlphaSurfaces = alpha.Count == 0 ? null : Search(alpha, threads);
        AlphaCasters = alpha.All(Casts) ? AlphaSurfaces : alpha.Any(Casts) ? Search([.. alpha.Where(Casts)], threads) : null;
        Bytes = _memory.Bytes + _all.Bytes + (_casters == _all ? 0 : _casters.Bytes) + meshes.Sum(mesh => mesh.Bytes);
        (Lights, Environments) = PackLights(scene);
        foreach (AmbientLight light in scene.Lights.OfType<AmbientLight>())
        {
            Ambient += light.Intensity;
        }
    }

    /// <summary>Whether work that cannot change the picture is left out.</summary>
    public bool IsSkipping { get; }

    /// <summary>Textures that the scene names and no pixel can show, not made ready.</summary>
    public int TexturesSkipped { get; }

    /// <summary>The camera.</summary>
    public Camera Camera { get; }

    /// <summary>The textures that are in use.</summary>
    public TexturePreparation Textures { get; }

    /// <summary>What rays see that hit nothing: a material with emission only, mapped by direction.</summary>
    public CompiledMaterial Background { get; }

    /// <summary>Where a direction of the background lies in the world.</summary>
    public Transform BackgroundRotation { get; }

    /// <summary>Lamps whose light has a direction.</summary>
    public Light[] Lights { get; }

    /// <summary>Lamp by lamp: what makes it light from all around, or null.</summary>
    public CompiledEnvironment?[] Environments { get; }

    /// <summary>Sum of all light from around that is the same in every direction: multiplies the diffuse coefficient.</summary>
    public Intensity EvenSky { get; private set; }

    /// <summary>Tells whether rendering takes several samples of something: then pixels need random numbers.</summary>
    public bool NeedsSampling => Camera.HasLens || Lights.Any(light => light.SampleCount > 1 || light is EnvironmentLight);

    /// <summary>Sum of all ambient light.</summary>
    public Intensity Ambient { get; }

    /// <summary>Distinct pairs of shape class and material: hits are grouped by them.</summary>
    public List<ShadingKey<R, F, I>> Keys { get; } = [];

    /// <summary>The objects with an opacity, which the searches below do not look at; null if there are none.</summary>
    public SceneBvh<R, F, I>? AlphaSurfaces { get; }

    /// <summary>Those of them that cast shadows; null if there are none.</summary>
    public SceneBvh<R, F, I>? AlphaCasters { get; }

    /// <summary>Tells whether some texture is filtered, so that rays must carry differentials.</summary>
    public bool NeedsDifferentials => !IsSkipping || Keys.Select(key => key.Material).Append(Background).SelectMany(material => material.AllTextures).Any(list => list.NeedsFootprints);

    /// <summary>Bytes of packed shapes, of meshes, and of what searches them.</summary>
    public long Bytes { get; }

    /// <summary>The member number of each object in its group.</summary>
    public int* MemberOfObject => _memberOfObject;

    /// <summary>The number of an object's key.</summary>
    public int KeyOf(int number) => _keyOfObject[number];

    /// <summary>Finds the nearest hit of every ray.</summary>
    public void Nearest(RayBatch<R, F, I> rays, HitBatch<R, F, I> hits)
    {
        hits.Clear(rays);
        rays.Renew();
        _all.Nearest(rays, hits, 0, rays.Packets);
    }

    /// <summary>Turns off the rays in groups of lanes [first, end) that something blocks before their limit.</summary>
    public void Block(RayBatch<R, F, I> rays, int first, int end) => _casters.Block(rays, first, end);

    /// <summary>Lists the opaque objects that may block any of some shadow rays: <see cref="SceneBvh{R, F, I}.FindBlockers"/>.</summary>
    public int FindBlockers(in RayBounds bounds, int source, BundleCandidate* found) => _casters.FindBlockers(bounds, source, found);

    /// <summary>Turns off the rays in groups of lanes [first, end) that any of those objects blocks before their limit.</summary>
    public void Block(RayBatch<R, F, I> rays, int first, int end, BundleCandidate* found, int count) => _casters.Block(rays, first, end, found, count);

    public void Dispose()
    {
        _all.Dispose();
        _casters.Dispose();
        AlphaSurfaces?.Dispose();
        AlphaCasters?.Dispose();
        _memory.Dispose();
    }

    private bool HasOpacity(ObjectEntry<R, F, I> entry) => Keys[KeyOf(entry.Number)].Material.Opacity is not null;

    /// <summary>The meshes of a scene. Their trees need no textures: other threads start on them while textures are decoded.</summary>
    private static HashSet<TriangleMesh> StartTrees(Scene scene, int threads)
    {
        HashSet<TriangleMesh> meshes = [];
        foreach (SceneObject item in scene.Objects)
        {
            if (item.Shape is TriangleMesh mesh && meshes.Add(mesh) && threads > 1)
            {
                Task.Run(() => mesh.Tree(threads));
            }
        }

        return meshes;
    }

    private SceneBvh<R, F, I> Search(IReadOnlyList<ObjectEntry<R, F, I>> entries, int threads) => new(
        [.. entries.Select(entry => entry.Bounds)], [.. entries.Select(entry => entry.Group)], [.. entries.Select(entry => entry.Member)], threads, IsSkipping);

    /// <summary>A material that shines by direction and does nothing else.</summary>
    private CompiledMaterial Sky(TextureSlot radiance) =>
        new(new Material { Emission = radiance, Diffuse = Intensity.Black, Shader = LambertShader.Default }, new SphericalMapping(), Textures);

    private (Light[] Lights, CompiledEnvironment?[] Environments) PackLights(Scene scene)
    {
        List<(Light, CompiledEnvironment?)> packed = [];
        foreach (Light light in scene.Lights.Where(light => light is not AmbientLight))
        {
            CompiledEnvironment? environment = light is EnvironmentLight around ? new CompiledEnvironment(around, Sky(around.Radiance)) : null;
            if (environment is { IsConstant: true })
            {
                EvenSky += environment.Sky.Emission.Value;
            }
            else
            {
                packed.Add((light, environment));
            }
        }

        return ([.. packed.Select(item => item.Item1)], [.. packed.Select(item => item.Item2)]);
    }

    private List<ObjectEntry<R, F, I>> Pack(List<SceneObject> objects)
    {
        Dictionary<(Type Shape, bool IsIdentity), ShapeGroup<R, F, I>> groups = [];
        Dictionary<(ShapeGroup<R, F, I> Group, Material Material, IMapping Mapping), int> keys = [];
        Texture filler = new(new Intensity[,] { { Intensity.White } });
        List<ObjectEntry<R, F, I>> entries = [];
        for (int number = 0; number < objects.Count; number++)
        {
            SceneObject item = objects[number];
            (Type, bool) kind = (item.Shape.GetType(), item.Transform.IsIdentity);
            if (!groups.TryGetValue(kind, out ShapeGroup<R, F, I>? group))
            {
                group = item.Shape.CreateGroup<R, F, I>(item.Transform);
                groups[kind] = group;
                _groups.Add(group);
            }

            int member = group.Add(item.Shape, item.Transform, number);
            IMapping mapping = item.Shape.DefaultMapping;
            if (!keys.TryGetValue((group, item.Material, mapping), out int key))
            {
                key = Keys.Count;
                keys[(group, item.Material, mapping)] = key;
                Keys.Add(new ShadingKey<R, F, I>(group, new CompiledMaterial(item.Material, mapping, Textures, IsSkipping ? null : filler)));
            }

            _memberOfObject[number] = member;
            _keyOfObject[number] = key;
            if (Keys[key].Material.Opacity is not { IsInvisible: true })
            {
                entries.Add(new ObjectEntry<R, F, I>(number, group, member, item.Shape.Bounds.Transformed(item.Transform)));
            }
        }

        return entries;
    }
}
