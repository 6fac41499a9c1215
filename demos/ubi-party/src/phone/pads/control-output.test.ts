import { expect, test } from 'vitest';
import { ControlOutput } from './control-output.ts';

function recorded() {
  const sent: unknown[] = [];
  const output = new ControlOutput({
    steer: (x, y) => sent.push([x, y]),
    press: (isDown) => sent.push(isDown),
  });
  return { output, sent };
}

test('steering is sent once per frame, and only when it has changed', () => {
  const { output, sent } = recorded();
  output.steer('thumb', { x: 0.2, y: 0 });
  output.steer('thumb', { x: 0.5, y: 0.1 });
  expect(sent).toEqual([]);
  output.frame();
  output.frame();
  output.steer('thumb', { x: 0.501, y: 0.1 });
  output.frame();
  expect(sent).toEqual([[0.5, 0.1]]);
});

test('press is sent at once, and once for all that hold the button', () => {
  const { output, sent } = recorded();
  expect(output.press('pad', true)).toBe(true);
  expect(output.press('keys', true)).toBe(false);
  output.press('pad', false);
  expect(sent).toEqual([true]);
  output.press('keys', false);
  expect(sent).toEqual([true, false]);
});

test('thumb wins over tilt, which goes on after it', () => {
  const { output, sent } = recorded();
  output.steer('tilt', { x: -0.3, y: 0 });
  output.steer('thumb', { x: 0, y: 0 });
  output.frame();
  output.steer('thumb', undefined);
  output.frame();
  expect(sent).toEqual([[-0.3, 0]]);
});

test('release lets the stick and the button go', () => {
  const { output, sent } = recorded();
  output.steer('keys', { x: 1, y: 0 });
  output.press('pad', true);
  output.frame();
  output.release();
  output.release();
  expect(sent).toEqual([true, [1, 0], false, [0, 0]]);
});
