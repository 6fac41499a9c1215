import type { TopicRecord } from '@ubii/proto';
import { afterAll, afterEach, beforeEach, expect, it, vi } from 'vitest';
import { effectScope, ref, shallowRef, type EffectScope } from 'vue';
import { useControl, type Control } from './useControl.ts';

const publish = vi.fn();
let reportError: (problem: Error) => void;
const isConnected = ref(true);
const state = shallowRef({ status: 'connected' });
const client = {
  role: 'participant',
  publish,
  onError(listener: typeof reportError) {
    reportError = listener;
    return () => {};
  },
};
// Test files share modules: reset them before and after mocking.
vi.hoisted(() => vi.resetModules());
afterAll(() => void vi.resetModules());
vi.mock('../../../connection/useConnection.ts', () => ({
  useConnection: () => ({ isConnected, state, client }),
}));

let scope: EffectScope;
let frames: (() => void)[];
const record = shallowRef<TopicRecord>();
const heard = (format: string, value: unknown): TopicRecord =>
  ({ topic: '/lab/light', format, value }) as TopicRecord;

function control(settings = {}): Control {
  return scope.run(() =>
    useControl(
      () => ({ topic: '/lab/light', record: record.value, settings }),
      ['double', 'float', 'int32'],
    ),
  )!;
}
const nextFrame = () => frames.splice(0).forEach((run) => run());

beforeEach(() => {
  publish.mockClear();
  frames = [];
  client.role = 'participant';
  isConnected.value = true;
  record.value = undefined;
  vi.useFakeTimers();
  vi.stubGlobal('requestAnimationFrame', (run: () => void) => frames.push(run));
  scope = effectScope();
});
afterEach(() => {
  scope.stop();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

it('publishes the newest value of a frame, once, and nothing while it rests', () => {
  const { sendLive } = control({ format: 'float' });
  sendLive(0.1);
  sendLive(0.2);
  nextFrame();
  nextFrame();
  expect(publish.mock.calls).toEqual([['/lab/light', 'float', 0.2, { keepSeconds: 3600 }]]);
});

it('publishes a value that waits before the next one, and when the panel goes', () => {
  const { send, sendLive } = control();
  sendLive(0.1);
  send(1, false);
  sendLive(0.3);
  scope.stop();
  nextFrame();
  expect(publish.mock.calls.map(([, , value, options]) => [value, options])).toEqual([
    [0.1, { keepSeconds: 3600 }],
    [1, {}],
    [0.3, { keepSeconds: 3600 }],
  ]);
});

it('shows its own value until that came back, then that of others', () => {
  record.value = heard('double', 0.5);
  const { value, sendLive } = control();
  expect(value.value).toBe(0.5);
  sendLive(0.9);
  record.value = heard('double', 0.8);
  expect(value.value).toBe(0.9);
  vi.advanceTimersByTime(500);
  expect(value.value).toBe(0.8);
});

it('has the data format of the topic, when it can send it', () => {
  const { format } = control({ format: 'float' });
  expect(format.value).toBe('float');
  record.value = heard('int32', 3);
  expect(format.value).toBe('int32');
  record.value = heard('string', 'x');
  expect(format.value).toBe('float');
});

it('publishes nothing as a viewer or without a connection, and says why', () => {
  client.role = 'viewer';
  const { send, sendLive, reason, value } = control();
  expect(reason.value).toBe('You joined as a viewer, which does not publish.');
  send(1, true);
  sendLive(1);
  nextFrame();
  isConnected.value = false;
  expect(reason.value).toBe('Not connected to the master.');
  expect(publish).not.toHaveBeenCalled();
  expect(value.value).toBeUndefined();
});

it('says why the master refused its value, and only for its topic', () => {
  const { error, send } = control();
  reportError(new Error('The record on "/other" was refused.'));
  expect(error.value).toBeUndefined();
  reportError(new Error('The record on "/lab/light" was refused.'));
  expect(error.value).toContain('was refused');
  send(1, true);
  expect(error.value).toBeUndefined();
});
