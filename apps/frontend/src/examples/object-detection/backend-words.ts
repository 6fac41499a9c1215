const NAMES: Readonly<Record<string, string>> = {
  webgpu: 'WebGPU',
  webgl: 'WebGL',
  wasm: 'WebAssembly',
  cpu: 'plain JavaScript',
};

/** Describes a backend of TensorFlow.js, with the graphics card if it uses one. */
export function backendWords(backend: string, gpu: string | undefined): string {
  const name = NAMES[backend] ?? backend;
  const isOnGpu = backend === 'webgpu' || backend === 'webgl';
  return isOnGpu && gpu !== undefined ? `${name}, ${gpu}` : name;
}

/**
 * Returns the product name of a graphics card.
 * @param renderer renderer string of WebGL: `ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 Direct3D11 vs_5_0 ps_5_0, D3D11)`
 */
export function gpuName(renderer: string): string | undefined {
  const inner = /^ANGLE \((.*)\)$/.exec(renderer)?.[1];
  const whole = inner?.split(', ')[1] ?? inner ?? renderer;
  const name = whole
    .replace(/^ANGLE Metal Renderer: /, '')
    .replace(/ ?\((TM|R)\)/g, '')
    .replace(/\s(Direct3D|OpenGL|Vulkan|vs_|\().*$/, '')
    .replace(/^(NVIDIA|AMD|Intel) (?=\S)/, '')
    .trim();
  return name === '' || /^(Mozilla|WebKit WebGL)$/.test(name) ? undefined : name;
}

/** Returns the graphics card of this browser; `undefined` where it is not available. */
export function ownGpu(): string | undefined {
  const context = document.createElement('canvas').getContext('webgl');
  const info = context?.getExtension('WEBGL_debug_renderer_info');
  const renderer = String(context?.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? 0) ?? '');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return gpuName(renderer);
}
