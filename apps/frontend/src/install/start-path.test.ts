// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { rememberStart, startPath } from './start-path.ts';

let isHandheld = true;
beforeEach(() => {
  localStorage.clear();
  vi.stubGlobal('matchMedia', () => ({ matches: isHandheld }));
});
afterEach(() => {
  vi.unstubAllGlobals();
});

it('a phone starts as a smart device, later as what it was used for', () => {
  isHandheld = true;
  expect(startPath()).toBe('/devices/smart-device');
  rememberStart('/devices/controller');
  expect(startPath()).toBe('/devices/controller');
});

it('viewers and desktop browsers start at Home', () => {
  isHandheld = true;
  rememberStart('/devices/controller');
  expect(startPath(false)).toBe('/');
  isHandheld = false;
  expect(startPath()).toBe('/');
});
