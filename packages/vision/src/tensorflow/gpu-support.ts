/** Interfaces of a worker to the graphics card. */
export interface GpuSupport {
  /** Why there is none, one sentence; undefined when there is one. */
  readonly absence?: string;
  /** Without a graphics card: a tenth of the speed of wasm, and seconds to compile shaders. */
  readonly isSoftware: boolean;
}

/** Names of renderers that work without a graphics card. */
const SOFTWARE_RENDERERS = /swiftshader|llvmpipe|softpipe|basic render|software/i;

const absent = (absence: string): GpuSupport => ({ absence, isSoftware: false });

/** Looks for WebGL 2 in this worker. */
export function webglSupport(): GpuSupport {
  if (typeof OffscreenCanvas === 'undefined') {
    return absent('WebGL in workers needs OffscreenCanvas, which is missing here.');
  }
  const context = new OffscreenCanvas(1, 1).getContext('webgl2');
  if (context === null) return absent('This browser has no WebGL 2 in workers.');
  const info = context.getExtension('WEBGL_debug_renderer_info');
  const name = String(context.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return { isSoftware: SOFTWARE_RENDERERS.test(name) };
}

/** Looks for WebGPU in this worker. */
export async function webgpuSupport(): Promise<GpuSupport> {
  const gpu = typeof navigator === 'undefined' ? undefined : (navigator as Partial<Navigator>).gpu;
  if (gpu === undefined) return absent('WebGPU in workers is missing here.');
  const adapter = await gpu.requestAdapter().catch(() => null);
  if (adapter === null) return absent('WebGPU found no graphics card that it can use.');
  const { isFallbackAdapter, vendor, architecture, description } = adapter.info;
  const isSoftware =
    isFallbackAdapter || SOFTWARE_RENDERERS.test(`${vendor} ${architecture} ${description}`);
  // Its first detection takes longer than the 10 s that a call may wait.
  return isSoftware
    ? absent('WebGPU has no graphics card here, and its software renderer is too slow.')
    : { isSoftware };
}
