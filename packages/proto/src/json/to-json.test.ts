import { describe, expect, it } from 'vitest';
import { toJson } from './to-json.ts';

describe('toJson [SV-4]', () => {
  it('writes camelCase keys, enum names, scalar defaults and empty lists, but no unset message', () => {
    expect(toJson('ubii.clients.Client', { id: 'c', devices: [{ name: 'd' }] })).toEqual({
      id: 'c',
      name: '',
      devices: [
        {
          id: '',
          name: 'd',
          deviceType: 'PARTICIPANT',
          components: [],
          clientId: '',
          tags: [],
          description: '',
        },
      ],
      tags: [],
      description: '',
      processingModules: [],
      isDedicatedProcessingNode: false,
      hostIp: '',
      metadataJson: '',
      state: 'ACTIVE',
      latency: 0,
    });
  });

  it('writes the defaults that the original interface reads without a check', () => {
    expect(toJson('ubii.servers.Server', {})).toMatchObject({ ipWlan: '', ipEthernet: '' });
  });

  it('writes the set member of a oneof only, also when it is empty', () => {
    expect(toJson('ubii.services.ServiceReply', { componentList: {} })).toEqual({
      componentList: { elements: [] },
    });
    expect(toJson('ubii.topicData.TopicDataRecord', { topic: '/t', double: 0 })).toEqual({
      topic: '/t',
      clientId: '',
      double: 0,
    });
    expect(toJson('ubii.services.ServiceReply', {})).toEqual({});
  });

  it('writes 64-bit integers as text and 32-bit ones as numbers', () => {
    expect(toJson('ubii.topicData.Timestamp', { millis: 1763722000123 })).toEqual({
      seconds: '0',
      nanos: 0,
      millis: '1763722000123',
    });
    expect(toJson('ubii.topicData.Timestamp', { millis: -(2 ** 63) })).toMatchObject({
      millis: '-9223372036854775808',
    });
  });

  it('writes bytes as base64 with padding', () => {
    const json = toJson('ubii.dataStructure.Image2D', {
      data: new Uint8Array([0xfb, 0xff, 0xbf, 1]),
    });
    expect(json['data']).toBe('+/+/AQ==');
    const large = new Uint8Array(100_000).map((_byte, i) => i);
    expect(toJson('ubii.dataStructure.Image2D', { data: large })['data']).toBe(
      Buffer.from(large).toString('base64'),
    );
  });

  it('writes what JSON has no numbers for as text', () => {
    expect(toJson('ubii.dataStructure.Vector3', { x: NaN, y: Infinity, z: -Infinity })).toEqual({
      x: 'NaN',
      y: 'Infinity',
      z: '-Infinity',
    });
  });

  it('writes enum numbers without a name as numbers', () => {
    expect(toJson('ubii.clients.Client', { state: 99 as 0 })['state']).toBe(99);
  });

  it('writes fields of our own only when they are set and not empty', () => {
    expect(toJson('ubii.general.Error', { title: 't', code: '' })).toEqual({
      title: 't',
      message: '',
      stack: '',
    });
    expect(toJson('ubii.general.Error', { code: 'not_found' })['code']).toBe('not_found');
    const subscription = toJson('ubii.services.request.TopicSubscription', { maxRateHz: 0 });
    expect(subscription).not.toHaveProperty('maxRateHz');
    expect(toJson('ubii.clients.Client', { extension: {} })['extension']).toEqual({
      credential: '',
      credentialExpiresMs: 0,
      recordLists: false,
      resumeToken: '',
      resumed: false,
      sentMs: 0,
      masterVersion: '',
      library: '',
      masters: [],
      masterId: '',
      role: 'ACCESS_ROLE_NONE',
      tellsTime: false,
      abridged: false,
      registrationRevision: 0,
    });
  });
});
