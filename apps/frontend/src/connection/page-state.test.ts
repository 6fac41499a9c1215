import { describe, expect, it } from 'vitest';
import { isPageStateTopic, pageStateTopic, readPageState, writePageState } from './page-state.ts';

describe('the state of a page, as it travels [EX-56]', () => {
  it.each([
    { isVisible: true, battery: undefined },
    { isVisible: false, battery: { level: 0.42, isCharging: true } },
    { isVisible: true, battery: { level: 0, isCharging: false } },
  ])('%o comes as it went', (state) => {
    expect(readPageState(writePageState(state))).toEqual(state);
  });

  it('says no more of the battery than people need', () => {
    const battery = { level: 0.123_456, isCharging: false };
    expect(writePageState({ isVisible: true, battery })).toBe(
      '{"visible":true,"battery":0.12,"charging":false}',
    );
  });

  it.each([
    '',
    'no JSON',
    'null',
    '7',
    '{}',
    '{"visible":"yes"}',
    `{"visible":true}${' '.repeat(1_000)}`,
  ])('takes "%s" for nothing', (text) => expect(readPageState(text)).toBeUndefined());

  it.each(['"full"', '2', '-1', 'null'])('takes a battery of %s for none', (battery) => {
    expect(readPageState(`{"visible":true,"battery":${battery}}`)).toEqual({
      isVisible: true,
      battery: undefined,
    });
  });

  it('has a topic of its own for each client', () => {
    expect(isPageStateTopic(pageStateTopic('ada'))).toBe(true);
    expect(isPageStateTopic('/ada/pad/page_state')).toBe(false);
  });
});
