import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { decode, type MessageType } from '../codec.ts';
import { DecodeError } from '../decode-error.ts';
import { MESSAGES } from '../descriptor.ts';
import { arbitraryMessage } from '../testing/arbitrary-message.ts';
import { findJsonProblems, fromJson } from './from-json.ts';
import { toJson } from './to-json.ts';

const TYPES = [...MESSAGES.keys()] as MessageType[];

describe('fromJson [SV-3]', () => {
  it.each([
    ['camelCase', { isDedicatedProcessingNode: true, hostIp: 'a' }],
    ['snake_case', { is_dedicated_processing_node: true, host_ip: 'a' }],
  ])('reads %s keys', (_name, json) => {
    expect(fromJson('ubii.clients.Client', json)).toMatchObject({
      isDedicatedProcessingNode: true,
      hostIp: 'a',
    });
  });

  it.each([
    ['a name', 'UNAVAILABLE', 2],
    ['a number', 1, 1],
    ['a number as text', '2', 2],
    ['an unknown number', 9, 9],
  ])('reads an enum given as %s', (_name, json, state) => {
    expect(fromJson('ubii.clients.Client', { state: json }).state).toBe(state);
  });

  it.each([
    [1.5, 1.5],
    ['1.5', 1.5],
    ['1e3', 1000],
    ['-0', -0],
    ['NaN', NaN],
    ['Infinity', Infinity],
    ['-Infinity', -Infinity],
  ])('reads the number %j', (json, number) => {
    expect(fromJson('ubii.dataStructure.Vector2', { x: json }).x).toBe(number);
  });

  it('reads 64-bit integers given as text, as proto3 JSON writes them', () => {
    expect(fromJson('ubii.topicData.Timestamp', { millis: '1763722000123' }).millis).toBe(
      1763722000123,
    );
  });

  it.each([
    ['base64', '+/+/AQ=='],
    ['base64 without padding', '+/+/AQ'],
    ['base64url', '-_-_AQ'],
  ])('reads bytes given as %s', (_name, data) => {
    expect([...fromJson('ubii.dataStructure.Image2D', { data }).data]).toEqual([
      0xfb, 0xff, 0xbf, 1,
    ]);
  });

  it('[CL-2] drops null members and null elements', () => {
    const client = fromJson('ubii.clients.Client', {
      name: null,
      tags: [null, 'a', null],
      devices: null,
      processingModules: [null, { name: 'pm', inputs: [null] }],
    });
    expect(client.name).toBe('');
    expect(client.tags).toEqual(['a']);
    expect(client.devices).toEqual([]);
    expect(client.processingModules).toHaveLength(1);
    expect(client.processingModules[0]).toMatchObject({ name: 'pm', inputs: [] });
  });

  it('[CL-2] drops unknown keys, the names of oneofs included', () => {
    const request = fromJson('ubii.services.ServiceRequest', {
      topic: '/services/device/registration',
      type: 'device',
      device: { name: 'd', helper: { a: [1] }, components: [{ topic: '/t', element: {} }] },
      somethingElse: [[[]]],
    });
    expect(request.device).toMatchObject({ name: 'd', components: [{ topic: '/t' }] });
    expect(Object.keys(request)).toEqual(['topic', 'device']);
  });

  it('is not harmed by keys with a meaning in JavaScript', () => {
    const json = JSON.parse(
      '{"__proto__":{"polluted":1},"constructor":{"a":1},"toString":2,"id":"c"}',
    ) as unknown;
    const client = fromJson('ubii.clients.Client', json);
    expect(client.id).toBe('c');
    expect(Object.getPrototypeOf(client)).toBe(Object.prototype);
    expect('polluted' in {}).toBe(false);
    expect('polluted' in client).toBe(false);
    const mapping = JSON.parse('{"__proto__":{"x":1},"topicSource":"/a"}') as unknown;
    expect(fromJson('ubii.sessions.TopicInputMapping', mapping)).toEqual({
      inputName: '',
      topic: '/a',
      constantJson: '',
    });
  });

  it('does not look into nesting the schema does not have', () => {
    const deep = '['.repeat(200_000) + ']'.repeat(200_000);
    const json = JSON.parse(`{"id":"c","unknown":${deep}}`) as unknown;
    expect(fromJson('ubii.clients.Client', json).id).toBe('c');
  });

  it('keeps the last member of a oneof', () => {
    expect(
      fromJson('ubii.topicData.TopicDataRecord', { topic: '/t', double: 1, vector2: { x: 1 } }),
    ).toStrictEqual({
      topic: '/t',
      timestamp: undefined,
      clientId: '',
      extension: undefined,
      vector2: { x: 1, y: 0 },
    });
  });

  it('gives what decode gives', () => {
    expect(fromJson('ubii.sessions.Session', {})).toStrictEqual(
      decode('ubii.sessions.Session', new Uint8Array(0)),
    );
  });

  it.each([
    ['the input', [1, 2], 'it must be an object, got a list of 2'],
    ['nothing', null, 'it must be an object, got null'],
    ['text', { client: { name: {} } }, 'client.name must be text, got an object'],
    ['a number', { client: { latency: 'fast' } }, 'client.latency must be a number, got "fast"'],
    [
      'an integer',
      {
        topicMux: {},
        sessionList: {
          elements: [{ processingModules: [{ processingMode: { frequency: { hertz: 1.5 } } }] }],
        },
      },
      'sessionList.elements[0].processingModules[0].processingMode.frequency.hertz must be an integer of 32 bits, got 1.5',
    ],
    [
      '32 bits',
      { lockstepProcessingRequest: { deltaTimeMs: 2 ** 31 } },
      'must be an integer of 32 bits',
    ],
    [
      'an enum',
      { client: { state: 'BUSY' } },
      'client.state must be one of ACTIVE, INACTIVE, UNAVAILABLE, got "BUSY"',
    ],
    ['a list', { client: { tags: 'a' } }, 'client.tags must be a list, got "a"'],
    [
      'true or false',
      { client: { isDedicatedProcessingNode: 'maybe' } },
      'must be true or false, got "maybe"',
    ],
    ['[DV-5] a device in a list', { device: [{}] }, 'device must be an object, got a list of 1'],
    [
      'base64',
      { lockstepProcessingRequest: { records: [{ image2D: { data: '*' } }] } },
      'records[0].image2D.data must be base64 text, got "*"',
    ],
  ])('refuses what is not %s and names the member', (_name, json, reason) => {
    expect(() => fromJson('ubii.services.ServiceRequest', json)).toThrow(DecodeError);
    expect(() => fromJson('ubii.services.ServiceRequest', json)).toThrow(reason);
  });

  it.each(TYPES)('%s: reads what toJson wrote', (type) => {
    fc.assert(
      fc.property(arbitraryMessage(type), (message) => {
        const text = JSON.stringify(toJson(type, message as never));
        const read = fromJson(type, JSON.parse(text));
        expect(read).toEqual(withoutNegativeZero(message));
      }),
      { numRuns: 10 },
    );
  });

  it('refuses more messages than honest ones hold', () => {
    const elements = (count: number): object => ({
      elements: Array.from({ length: count }, () => ({})),
    });
    expect(() => fromJson('ubii.dataStructure.Vector2List', elements(399_999))).not.toThrow();
    expect(() => fromJson('ubii.dataStructure.Vector2List', elements(400_000))).toThrow(
      'more than 400000 messages within one',
    );
  });

  it('throws nothing but DecodeError', () => {
    fc.assert(
      fc.property(fc.constantFrom(...TYPES), fc.jsonValue(), (type, json) => {
        const fields = [...MESSAGES.get(type)!.fieldByName.keys()];
        const shaped = Object.fromEntries(fields.map((field) => [field, json]));
        try {
          fromJson(type, shaped);
        } catch (error) {
          if (!(error instanceof DecodeError)) throw error;
        }
      }),
      { numRuns: 500 },
    );
  });
});

describe('the legacy form of mappings', () => {
  it.each([
    [{ topicSource: '/a' }, { topic: '/a' }],
    [{ topic_source: '/a' }, { topic: '/a' }],
    [{ topicSource: '/b', topic: '/a' }, { topic: '/a' }],
    [{ topicSource: '/b', topicMux: { id: 'm' } }, { topicMux: { id: 'm' } }],
    [{ topicSource: '/b', topic: '' }, { topic: '/b' }],
    [{ topicSource: 'topic' }, {}],
    [{ topicSource: 'topicMux' }, {}],
    [{ topicSource: 5 }, {}],
    [{ topicDestination: '/a' }, {}],
    [{ constantJson: '{"double":1}' }, { constantJson: '{"double":1}' }],
  ])('%j maps an input', (json, expected) => {
    expect(fromJson('ubii.sessions.TopicInputMapping', { inputName: 'i', ...json })).toMatchObject({
      inputName: 'i',
      ...expected,
    });
    if (Object.keys(expected).length === 0) {
      expect(fromJson('ubii.sessions.TopicInputMapping', json)).toEqual({
        inputName: '',
        constantJson: '',
      });
    }
  });

  it('maps an output', () => {
    const json = { outputName: 'o', topicDestination: '/a' };
    expect(fromJson('ubii.sessions.TopicOutputMapping', json).topic).toBe('/a');
    expect(
      fromJson('ubii.sessions.TopicOutputMapping', { topicDestination: 'topicDemux' }).topic,
    ).toBeUndefined();
  });
});

/** JavaScript writes -0 as 0. */
function withoutNegativeZero(value: unknown): unknown {
  if (value === 0) return 0;
  if (typeof value !== 'object' || value === null || value instanceof Uint8Array) return value;
  if (Array.isArray(value)) return value.map(withoutNegativeZero);
  return Object.fromEntries(
    Object.entries(value).map(([key, member]) => [key, withoutNegativeZero(member)]),
  );
}

describe('looking for everything that is wrong', () => {
  const RECORD = 'ubii.topicData.TopicDataRecord';

  it('names each place', () => {
    const record = { topic: '/a', pose3D: { position: { x: 'left', y: 'up', u: 1 } } };
    expect(findJsonProblems(RECORD, record)).toEqual([
      { path: 'pose3D.position.x', sentence: 'must be a number, got "left"' },
      { path: 'pose3D.position.y', sentence: 'must be a number, got "up"' },
      { path: 'pose3D.position.u', sentence: 'is not known here; there are x, y, z' },
    ]);
    expect(findJsonProblems(RECORD, { int32List: { elements: [1, 1.5] } })).toEqual([
      { path: 'int32List.elements[1]', sentence: 'must be an integer of 32 bits, got 1.5' },
    ]);
    expect(findJsonProblems(RECORD, { vector2List: { elements: 3 } })).toHaveLength(1);
    expect(findJsonProblems(RECORD, [])).toHaveLength(1);
  });

  it('proposes the name of a misspelt member, and names a few of many members', () => {
    expect(findJsonProblems(RECORD, { topic: '/a', strin: 'b' })).toEqual([
      { path: 'strin', sentence: 'is not known here. Did you mean string?' },
    ]);
    const [problem] = findJsonProblems(RECORD, { nothingLikeIt: 1 });
    expect(problem?.sentence).toMatch(/^is not known here; there are (\w+, ){4}\w+ and \d+ more$/);
  });

  it('names what cannot stand side by side, and finds nothing in what is fine', () => {
    expect(findJsonProblems(RECORD, { double: 1, bool: true })).toEqual([
      { path: 'bool', sentence: 'cannot stand beside double' },
    ]);
    expect(findJsonProblems(RECORD, { topic: '/a', double: '1.5' })).toEqual([]);
  });
});
