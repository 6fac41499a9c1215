import {
  moduleRuns,
  outputDecays,
  outputWithin,
  sessionRuns,
  topicArrives,
  tryIsFed,
  tryRuns,
} from '../model/checks.ts';
import type { Lesson } from '../model/lesson.ts';
import { MODULE_CODES } from './module-codes.ts';
import { outputOf } from './topics.ts';

const { first, remembers, smooths } = MODULE_CODES;

export const firstModule: Lesson = {
  id: 'first-module',
  title: 'First module',
  heading: 'Your first module, in five minutes',
  intro:
    'A module reads inputs, computes, and writes outputs. You will turn the pointer of this page into a speed.',
  minutes: 5,
  workspace: { kind: 'module', codes: [first, first, first, remembers, smooths] },
  steps: [
    {
      title: 'Run the module',
      text: 'The module has one input, `pointer`, and one output, `speed`. Its function `onProcessing` runs 30 times a second. Press Run: it runs in a sandbox of this tab, and nothing is published.',
      checks: [tryRuns(10, { id: 'runs', text: 'The module runs', todo: 'press Run' })],
      answer: { kind: 'try-run' },
    },
    {
      title: 'Feed it with the pointer',
      text: 'The input takes fixed values at first. Choose Topic at the input, then the topic that ends in `mouse_client_position`: the pointer of this browser. Move the pointer.',
      checks: [
        tryIsFed(5, {
          id: 'fed',
          text: 'The pointer feeds the module',
          todo: 'choose the topic, move',
        }),
      ],
      answer: { kind: 'try-topic' },
    },
    {
      title: 'Remember the last position',
      text: 'What you put on `state` is still there in the next run. Speed is the distance to the last position, divided by the time. Write this in place of `const speed = 0;` and press Run.',
      code: `const p = inputs.pointer.vector2;
const last = state.last ?? p;
state.last = p;
const way = Math.hypot(p.x - last.x, p.y - last.y);
const speed = way / (deltaTimeMs / 1000 || 1);`,
      checks: [
        outputWithin(0.2, 1000, {
          id: 'moves',
          text: '`speed` is above 0 while the pointer moves',
          todo: 'move the pointer',
        }),
        outputWithin(-0.001, 0.001, {
          id: 'rests',
          text: 'speed is 0 while the pointer rests',
          todo: 'hold still',
        }),
      ],
      answer: { kind: 'code', code: remembers },
    },
    {
      title: 'Smooth it with one number',
      text: 'The speed jumps. Keep 80 % of the value before and take 20 % of the new one. Output `state.smooth` in place of `speed`, press Run, move, and stop: the value now decays.',
      code: `state.smooth = 0.8 * (state.smooth ?? 0) + 0.2 * speed;
return { outputs: { speed: { double: state.smooth } } };`,
      checks: [
        outputDecays(8, {
          id: 'decays',
          text: 'speed decays over 8 runs or more',
          todo: 'move, then stop',
        }),
      ],
      answer: { kind: 'code', code: smooths },
    },
    {
      title: 'Put it into a session',
      text: 'So far, only this tab ran the module. Press Run in a session: the master runs it, takes the pointer from its topic and publishes the speed on another one. Every client can subscribe to it.',
      checks: [
        sessionRuns({ id: 'running', text: 'A session runs', todo: 'press Run in a session' }),
        moduleRuns('pointer-speed', 5, {
          id: 'module',
          text: 'The module runs on the master',
          todo: 'wait for its report',
        }),
        topicArrives(outputOf('speed'), 5, {
          id: 'arrives',
          text: 'The speed arrives on its topic',
          todo: 'move the pointer',
        }),
      ],
      answer: { kind: 'module-session' },
    },
  ],
};
