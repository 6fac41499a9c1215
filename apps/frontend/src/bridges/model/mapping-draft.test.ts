import { describe, expect, it } from 'vitest';
import { draftOf, isUnchanged, mappingOf } from './mapping-draft.ts';
import { carriageOf, lastErrorOf, lossesOf, passedOf } from './mapping-words.ts';

const heat = { direction: 'in', foreign: 'heat/+', topic: '/heat/{1}', format: 'double', qos: 1 };

describe('form of a mapping', () => {
  it('without changes writes the mapping as it was, with unknown members', () => {
    const odd = { ...heat, field: 'a.b', enabled: false, later: { version: 2 } };
    expect(mappingOf(draftOf(odd), 'mqtt', odd)).toEqual(odd);
    expect(isUnchanged(draftOf(odd), 'mqtt', odd)).toBe(true);
  });

  it('writes numbers as numbers, and leaves out what is the default', () => {
    const draft = { ...draftOf(), direction: 'out', foreign: 'a', topic: ' /a ', qos: '2' };
    expect(mappingOf({ ...draft, maxRateHz: '5' }, 'mqtt')).toEqual({
      direction: 'out',
      foreign: 'a',
      topic: '/a',
      format: 'double',
      qos: 2,
      maxRateHz: 5,
    });
  });

  it('leaves what is no number for the bridge to refuse', () => {
    expect(mappingOf({ ...draftOf(heat), maxTopics: 'many' }, 'mqtt', heat)).toMatchObject({
      maxTopics: 'many',
    });
  });

  it('removes what was emptied', () => {
    const before = { ...heat, name: 'heat', maxTopics: 3 };
    const draft = { ...draftOf(before), name: '', maxTopics: '' };
    expect(mappingOf(draft, 'mqtt', before)).toEqual(heat);
  });

  it.each([
    ['mqtt', 'qos', true],
    ['osc', 'timeTag', true],
    ['osc', 'qos', false],
    ['rosbridge', 'type', true],
  ])('of %s writes %s: %s', (protocol, member, has) => {
    const draft = { ...draftOf(), qos: '1', timeTag: true, type: 'std_msgs/Bool' };
    expect(member in mappingOf(draft, protocol)).toBe(has);
  });
});

describe('words for a mapping', () => {
  it('say how it carries values', () => {
    const words = carriageOf({ ...heat, field: 'value', retained: true, maxRateHz: 5 }, 'mqtt');
    expect(words).toBe('double · json value · QoS 1 · retained · at most 5/s');
    expect(carriageOf({ direction: 'out' }, 'osc')).toBe('any format');
  });

  it('count what was lost, with the newest reason of both directions', () => {
    const lane = { passed: 0, refused: 0, dropped: 0, returned: 0, evicted: 0, topics: 0 };
    const error = (message: string, atMs: number) => ({ message, atMs, address: 'a' });
    const report = {
      name: 'heat',
      in: {
        ...lane,
        passed: 2,
        refused: 2,
        lastError: error('no number', 5),
        lastValue: undefined,
      },
      out: {
        ...lane,
        passed: 4,
        refused: 1,
        dropped: 3,
        evicted: 2,
        lastError: error('full', 9),
        lastValue: undefined,
      },
    };
    expect(lossesOf(report)).toBe('3 refused, 3 dropped, 2 evicted');
    expect(lastErrorOf(report)?.message).toBe('full');
    expect(lossesOf(undefined)).toBe('');
    expect(passedOf(report)).toBe(6);
  });
});
