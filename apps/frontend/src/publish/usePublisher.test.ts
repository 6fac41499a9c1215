import { afterAll, afterEach, beforeEach, expect, it, vi } from 'vitest';
import { effectScope, ref, type EffectScope } from 'vue';
import { usePublisher, type Publisher } from './usePublisher.ts';

const publish = vi.fn();
let reportError: (problem: Error) => void;
const isConnected = ref(true);
// Test files share modules: reset them before and after mocking.
vi.hoisted(() => vi.resetModules());
afterAll(() => void vi.resetModules());
vi.mock('../connection/useConnection.ts', () => ({
  useConnection: () => ({
    isConnected,
    client: {
      publish,
      onError(listener: typeof reportError) {
        reportError = listener;
        return () => {};
      },
    },
  }),
}));

let scope: EffectScope;
let publisher: Publisher;
beforeEach(() => {
  publish.mockClear();
  isConnected.value = true;
  vi.useFakeTimers();
  scope = effectScope();
  publisher = scope.run(() => usePublisher())!;
  publisher.draft.setJson({ topic: '/lab', double: 1 });
});
afterEach(() => {
  scope.stop();
  vi.useRealTimers();
});

it('publishes what is on the page', () => {
  expect(publisher.reason.value).toBeUndefined();
  expect(publisher.send()).toBe(true);
  expect(publish).toHaveBeenCalledWith('/lab', 'double', 1, expect.anything());
  expect(publisher.sent.value).toBe(1);
});

it('publishes nothing while the text is no JSON, once or repeatedly', () => {
  publisher.repeat(10);
  expect(publish).toHaveBeenCalledTimes(1);
  publisher.draft.setText(`${publisher.draft.text.value}}`);
  expect(publisher.reason.value).toMatch(/^The JSON is not valid\. Line 4/);
  expect(publisher.send()).toBe(false);
  vi.advanceTimersByTime(1000);
  expect(publish).toHaveBeenCalledTimes(1);
  expect(publisher.error.value).toMatch(/^Not published: The JSON is not valid/);
});

it('drops an error with the next edit', () => {
  publisher.draft.setJson({ topic: '/lab', double: 'a' });
  publisher.send();
  expect(publisher.error.value).toBe('Not published: double must be a number, got "a".');
  publisher.draft.setText('{"topic": "/lab", "double": "ab"}');
  expect(publisher.error.value).toBeUndefined();
  reportError(new Error('The master refused it.'));
  expect(publisher.error.value).toBe('The master refused it.');
  publisher.draft.setJson({ topic: '/lab', double: 2 });
  expect(publisher.error.value).toBeUndefined();
});

it('publishes nothing without a connection', () => {
  isConnected.value = false;
  expect(publisher.reason.value).toBe('This page is not connected to the master.');
  expect(publisher.send()).toBe(false);
  expect(publish).not.toHaveBeenCalled();
});
