import { describe, expect, it } from 'vitest';
import { joinRow, type JoinRowFacts } from './join-row.ts';
import type { Check, CheckId, CheckState } from './preflight/check.ts';

const check = (id: CheckId, state: CheckState): Check => ({ id, state, title: id, text: '' });
const WELL: JoinRowFacts = {
  checks: ['master', 'secure', 'channel', 'clock', 'sensors'].map((id) =>
    check(id as CheckId, 'good'),
  ),
  isUnreachable: false,
  trouble: '',
  isJoining: false,
  usesSensors: true,
  refusals: 0,
};
/** All is well, but for these. */
const but = (...wrong: Check[]): JoinRowFacts => ({
  ...WELL,
  checks: WELL.checks.map((one) => wrong.find(({ id }) => id === one.id) ?? one),
});

describe('the row above Join', () => {
  it('is absent while all checks pass or run, and while iOS will ask for motion', () => {
    expect(joinRow(WELL)).toBeUndefined();
    expect(joinRow(but(check('master', 'checking'), check('channel', 'checking')))).toBeUndefined();
    expect(joinRow(but(check('sensors', 'asks'), check('clock', 'none')))).toBeUndefined();
  });

  it('is an error only when the host cannot be reached, or joining failed', () => {
    expect(joinRow(but(check('master', 'failed'), check('channel', 'failed')))?.tone).toBe('err');
    expect(joinRow({ ...WELL, isUnreachable: true })?.tone).toBe('err');
    expect(joinRow({ ...WELL, trouble: 'No live connection' })).toMatchObject({
      tone: 'err',
      text: 'No live connection',
    });
    expect(joinRow({ ...WELL, trouble: 'Retrying', isJoining: true })?.tone).toBe('warn');
    expect(joinRow(but(check('channel', 'failed')))?.tone).toBe('warn');
  });

  it('says what still works, and offers the remedy of the check', () => {
    const remedy = { text: 'Open the secure page', href: 'https://10.0.0.2' };
    const row = joinRow(but({ ...check('secure', 'warning'), remedy }));
    expect(row).toMatchObject({ title: 'This page is not secure', remedy });
    expect(row?.text).toContain('Touch and buttons work');
  });

  it('says nothing of sensors that the page does not use', () => {
    const facts = but(check('secure', 'warning'), check('sensors', 'warning'));
    expect(joinRow({ ...facts, usesSensors: false, refusals: 1 })).toBeUndefined();
  });

  it('asks for motion again, and after a second refusal says how', () => {
    const facts = but(check('sensors', 'warning'));
    expect(joinRow({ ...facts, refusals: 1 })).toMatchObject({
      title: 'Motion is blocked',
      remedy: 'ask-again',
    });
    expect(joinRow({ ...facts, refusals: 2 })?.text).toContain('close the browser completely');
    expect(joinRow(facts)?.title).toBe('No motion arrives');
  });

  it('mentions a wrong clock last', () => {
    const clock = check('clock', 'warning');
    expect(joinRow(but(clock))?.title).toBe('The clock is off');
    expect(joinRow(but(clock, check('sensors', 'warning')))?.title).toBe('No motion arrives');
  });
});
