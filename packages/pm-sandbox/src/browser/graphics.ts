/** Methods that a canvas has from `EventTarget`, which is stripped: with it, code could listen to the worker itself. */
const LISTENING = ['addEventListener', 'removeEventListener', 'dispatchEvent'] as const;

/**
 * Keeps what libraries need to compute on the graphics card: a canvas that can be listened to, for WebGL, and
 * `navigator.gpu`, for WebGPU. To be called before the globals are stripped. [PM-97]
 *
 * @returns the globals that stay, by name
 */
export function keepGraphics(): Readonly<Record<string, unknown>> {
  if (typeof OffscreenCanvas !== 'undefined') keepListening(OffscreenCanvas.prototype);
  const { gpu } = navigator as { readonly gpu?: unknown };
  return gpu === undefined ? {} : { navigator: Object.freeze({ gpu }) };
}

/** The methods on the prototype itself, for objects of its kind alone. */
function keepListening(prototype: OffscreenCanvas): void {
  // Throws for whatever is no canvas, also for what only inherits from one
  const checkKind = Object.getOwnPropertyDescriptor(prototype, 'width')!.get!;
  for (const name of LISTENING) {
    const method = EventTarget.prototype[name] as (...args: unknown[]) => unknown;
    Object.defineProperty(prototype, name, {
      value(this: OffscreenCanvas, ...args: unknown[]): unknown {
        Reflect.apply(checkKind, this, []);
        return Reflect.apply(method, this, args);
      },
    });
  }
}
