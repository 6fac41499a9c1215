import { expect, it } from 'vitest';
import { nextStep } from './next-step.ts';

const gathered = { phones: 2, touches: 0, isRunning: true };

it('asks for a second phone, also while the first one is touched', () => {
  expect(nextStep({ ...gathered, phones: 1, touches: 1 })).toContain('second phone');
});

it('asks for touches, and for a start before them', () => {
  expect(nextStep(gathered)).toMatch(/^Touch/);
  expect(nextStep({ ...gathered, isRunning: false })).toMatch(/^Start the session/);
});

it('is silent without phones, where a panel invites them, and while fingers are there', () => {
  expect(nextStep({ ...gathered, phones: 0 })).toBeUndefined();
  expect(nextStep({ ...gathered, touches: 1 })).toBeUndefined();
});
