import type { IoDraft, ModeDraft, ModuleDraft } from './module-draft.ts';

/** Template for a new module. */
export interface ModuleTemplate {
  readonly title: string;
  /** One sentence. */
  readonly about: string;
  readonly draft: ModuleDraft;
}

const io = (name: string, format: string, isList = false): IoDraft => ({ name, format, isList });
const mode = (kind: ModeDraft['kind'], rest: Partial<ModeDraft> = {}): ModeDraft => ({
  kind,
  hertz: 30,
  minDelayMs: 0,
  allInputsNeedUpdate: false,
  ...rest,
});

function draft(name: string, rest: Partial<ModuleDraft>): ModuleDraft {
  return {
    name,
    description: '',
    tags: [],
    authors: [],
    version: '',
    libraries: [],
    assets: [],
    optionalAssets: [],
    inputs: [],
    outputs: [],
    mode: mode('trigger'),
    code: '',
    ...rest,
  };
}

export const TEMPLATES: readonly ModuleTemplate[] = [
  {
    title: 'Blank',
    about: 'One input and one output, both numbers.',
    draft: draft('new-module', {
      inputs: [io('value', 'double')],
      outputs: [io('result', 'double')],
      code: `onProcessing = (deltaTimeMs, inputs, state) => {
  // The latest record of each input; an input without a record is undefined.
  if (!inputs.value) return;
  // A record for each output. What is stored in state stays for the next run.
  return { outputs: { result: { double: inputs.value.double } } };
};
`,
    }),
  },
  {
    title: 'Change each value',
    about: 'Runs when a point arrives, and outputs a changed point.',
    draft: draft('change-point', {
      inputs: [io('point', 'vector2')],
      outputs: [io('changed', 'vector2')],
      code: `onProcessing = (deltaTimeMs, inputs, state) => {
  if (!inputs.point) return;
  const { x, y } = inputs.point.vector2;
  return { outputs: { changed: { vector2: { x: 1 - x, y } } } };
};
`,
    }),
  },
  {
    title: 'Remember',
    about: 'Keeps state between runs, here a smoothed number.',
    draft: draft('smooth-number', {
      inputs: [io('value', 'double')],
      outputs: [io('smooth', 'double')],
      code: `onCreated = (state) => {
  state.smooth = 0;
};

onProcessing = (deltaTimeMs, inputs, state) => {
  if (!inputs.value) return;
  state.smooth += 0.1 * (inputs.value.double - state.smooth);
  return { outputs: { smooth: { double: state.smooth } } };
};
`,
    }),
  },
  {
    title: 'Generate',
    about: 'Has no inputs, and outputs a wave at 30 Hz.',
    draft: draft('wave', {
      outputs: [io('wave', 'double')],
      mode: mode('frequency'),
      code: `onCreated = (state) => {
  state.timeMs = 0;
};

onProcessing = (deltaTimeMs, inputs, state) => {
  state.timeMs += deltaTimeMs;
  return { outputs: { wave: { double: Math.sin(state.timeMs / 500) } } };
};
`,
    }),
  },
  {
    title: 'Many devices',
    about: 'Takes one point from each device, and returns one result to each.',
    draft: draft('answer-each', {
      inputs: [io('points', 'vector2', true)],
      outputs: [io('distances', 'double', true)],
      code: `onProcessing = (deltaTimeMs, inputs, state) => {
  const elements = inputs.points.elements.map(({ identity, vector2 }) => ({
    identity,
    double: Math.hypot(vector2.x - 0.5, vector2.y - 0.5),
  }));
  return { outputs: { distances: { elements } } };
};
`,
    }),
  },
];
