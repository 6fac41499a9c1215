import { expect, it } from 'vitest';
import { leaveKeys } from './leave-keys.ts';

it('names the keys of this computer', () => {
  expect(leaveKeys('Linux x86_64')).toBe('Ctrl M');
  expect(leaveKeys('Win32')).toBe('Ctrl M');
  expect(leaveKeys('MacIntel')).toBe('Ctrl Shift M');
});
