import { expect, it } from 'vitest';
import { createApp, type InjectionKey } from 'vue';
import { injectOrThrow } from './inject-or-throw.ts';

const PAGE: InjectionKey<string> = Symbol('page');

it('returns what is provided', () => {
  const app = createApp({});
  app.provide(PAGE, 'a page');
  expect(app.runWithContext(() => injectOrThrow(PAGE, 'the page above it'))).toBe('a page');
});

it('names what is missing', () => {
  const app = createApp({});
  expect(() => app.runWithContext(() => injectOrThrow(PAGE, 'the page above it'))).toThrow(
    'This part needs the page above it.',
  );
});
