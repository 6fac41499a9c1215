/** Code of the lesson "First module" at the start of each step, and at its end. */
const FIRST = `onProcessing = (deltaTimeMs, inputs, state) => {
  if (!inputs.pointer) return;
  const speed = 0;
  return { outputs: { speed: { double: speed } } };
};
`;

const REMEMBERS = `onProcessing = (deltaTimeMs, inputs, state) => {
  if (!inputs.pointer) return;
  const p = inputs.pointer.vector2;
  const last = state.last ?? p;
  state.last = p;
  const way = Math.hypot(p.x - last.x, p.y - last.y);
  const speed = way / (deltaTimeMs / 1000 || 1);
  return { outputs: { speed: { double: speed } } };
};
`;

const SMOOTHS = `onProcessing = (deltaTimeMs, inputs, state) => {
  if (!inputs.pointer) return;
  const p = inputs.pointer.vector2;
  const last = state.last ?? p;
  state.last = p;
  const way = Math.hypot(p.x - last.x, p.y - last.y);
  const speed = way / (deltaTimeMs / 1000 || 1);
  state.smooth = 0.8 * (state.smooth ?? 0) + 0.2 * speed;
  return { outputs: { speed: { double: state.smooth } } };
};
`;

export const MODULE_CODES = { first: FIRST, remembers: REMEMBERS, smooths: SMOOTHS } as const;
