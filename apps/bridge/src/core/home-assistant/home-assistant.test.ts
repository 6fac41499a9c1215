import { ComponentIOType } from '@ubii/proto';
import type { Component, Device } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { FakeClock } from '@ubii/timing/testing';
import { HomeAssistant } from './home-assistant.ts';

const settings = { prefix: 'homeassistant', topics: 'ubii' };

function component(name: string, messageFormat: string, isSubscriber = false): Component {
  const ioType = isSubscriber ? ComponentIOType.SUBSCRIBER : ComponentIOType.PUBLISHER;
  return { ...empty, name, messageFormat, ioType, topic: `/ada/lamp/${name}` };
}
const empty = { deviceId: '', tags: [], description: '', id: '', notifyConditionIds: [] };

function device(id: string, components: Component[], clientId = 'ada'): Device {
  return { id, clientId, components, name: 'lamp', description: '', tags: [], deviceType: 0 };
}

function createBench() {
  const clock = new FakeClock();
  const sent = new Map<string, string | undefined>();
  const homeAssistant = new HomeAssistant({
    settings,
    availability: 'bridge/status',
    clock,
    ownId: () => 'bridge',
    send: ({ address, payload }) =>
      void sent.set(address, payload && new TextDecoder().decode(payload)),
    onChange: () => undefined,
  });
  const config = (topic: string) =>
    JSON.parse(sent.get(topic) ?? 'null') as Record<string, unknown> | null;
  const find = (topic: string, content: string, isKept = true) => {
    const payload = new TextEncoder().encode(content);
    const sizes = {
      sizeBytes: payload.length,
      isEmpty: payload.length === 0,
      isOurs: true,
      isKept,
    };
    return homeAssistant.handleMessage({ address: topic, payload, ...sizes });
  };
  return { homeAssistant, sent, config, find, clock };
}

describe('discovery of Home Assistant [BR-50]', () => {
  it.each([
    ['double', false, 'sensor', { state_topic: 'ubii/d_1/v', state_class: 'measurement' }],
    ['ubii.dataStructure.int32', true, 'number', { command_topic: 'ubii/d_1/v/set', step: 1 }],
    ['bool', false, 'binary_sensor', { payload_on: 'true', payload_off: 'false' }],
    ['bool', true, 'switch', { command_topic: 'ubii/d_1/v/set', optimistic: true }],
    ['string', false, 'sensor', { state_topic: 'ubii/d_1/v' }],
    ['string', true, 'text', { command_topic: 'ubii/d_1/v/set' }],
    ['keyEvent', false, 'event', { event_types: ['press', 'release'] }],
  ])('tells %s (subscriber: %s) as %s', (format, isSubscriber, kind, expected) => {
    const { homeAssistant, config } = createBench();
    homeAssistant.handleDevices([device('d 1', [component('v', format, isSubscriber)])]);
    expect(config(`homeassistant/${kind}/ubii_d_1/v/config`)).toMatchObject({
      name: 'v',
      unique_id: 'ubii_d_1_v',
      availability_topic: 'bridge/status',
      device: { identifiers: ['ubii_d_1'], name: 'lamp' },
      ...expected,
    });
    const [mapping] = homeAssistant.mappings;
    expect(mapping).toMatchObject({
      direction: isSubscriber ? 'in' : 'out',
      topic: { text: '/ada/lamp/v' },
      qos: kind === 'event' ? 0 : 1,
      retained: !isSubscriber && kind !== 'event',
    });
  });

  it('counts components that Home Assistant has nothing for, and leaves out those of the bridge', () => {
    const { homeAssistant } = createBench();
    homeAssistant.handleDevices([
      device('a', [component('v', 'double'), component('p', 'vector3'), component('v', 'double')]),
      device('own', [component('v', 'double')], 'bridge'),
    ]);
    expect(homeAssistant.counts).toEqual({ entities: 1, skipped: 2 });
  });

  it('is removed with its device, and all of it when the bridge ends [BR-51]', () => {
    const { homeAssistant, sent } = createBench();
    const topic = (id: string) => `homeassistant/sensor/ubii_${id}/v/config`;
    homeAssistant.handleDevices([
      device('a', [component('v', 'double')]),
      device('b', [component('v', 'double')]),
    ]);
    homeAssistant.handleDevices([device('b', [component('v', 'double')])]);
    expect(sent.get(topic('a'))).toBeUndefined();
    expect(sent.has('ubii/a/v')).toBe(true);
    expect(sent.get(topic('b'))).toContain('"name":"v"');
    homeAssistant.close();
    expect(sent.get(topic('b'))).toBeUndefined();
  });

  it('is announced again when Home Assistant starts, and not more often than each 5 s [BR-52]', () => {
    const { homeAssistant, sent, find, clock } = createBench();
    const topic = 'homeassistant/sensor/ubii_a/v/config';
    homeAssistant.handleDevices([device('a', [component('v', 'double')])]);
    const announced = sent.get(topic);
    sent.clear();
    expect(find('homeassistant/status', 'offline', false)).toBe(false);
    find('homeassistant/status', 'online');
    expect([...sent.keys()]).toEqual([]);
    expect(find('homeassistant/status', 'online', false)).toBe(true);
    expect([...sent]).toEqual([[topic, announced]]);
    sent.clear();
    for (let time = 0; time < 100; time++) find('homeassistant/status', 'online', false);
    expect(sent.size).toBe(0);
    clock.advanceSync(5_000);
    expect([...sent.keys()]).toEqual([topic]);
    homeAssistant.close();
    expect(clock.timerCount).toBe(0);
  });

  it('leaves the devices to another bridge, and takes them over from it [BR-22]', () => {
    const { homeAssistant, sent } = createBench();
    const topic = 'homeassistant/sensor/ubii_a/v/config';
    homeAssistant.setActive(false);
    homeAssistant.handleDevices([device('a', [component('v', 'double')])]);
    expect([sent.size, homeAssistant.mappings, homeAssistant.subscriptions]).toEqual([0, [], []]);
    homeAssistant.setActive(true);
    expect(sent.get(topic)).toContain('"name":"v"');
    expect(homeAssistant.mappings).toHaveLength(1);
    sent.clear();
    homeAssistant.setActive(false);
    homeAssistant.close();
    // What the other one announces stays.
    expect(sent.size).toBe(0);
  });

  it('removes what an earlier run left, and nothing of others [BR-51]', () => {
    const { homeAssistant, sent, find } = createBench();
    const ours = '{"availability_topic":"bridge/status"}';
    const topic = (node: string) => `homeassistant/sensor/${node}/v/config`;
    expect(find(topic('ubii_old'), ours)).toBe(true);
    find(topic('ubii_a'), ours);
    find(topic('ubii_other'), '{"availability_topic":"other/status"}');
    find(topic('ubii_broken'), '{');
    find(topic('zigbee'), ours);
    expect(find('ubii/a/v', '1')).toBe(false);
    homeAssistant.handleDevices([device('a', [component('v', 'double')])]);
    expect([...sent.keys()]).toEqual([topic('ubii_old'), topic('ubii_a')]);
    expect(sent.get(topic('ubii_old'))).toBeUndefined();
    find(topic('ubii_late'), ours);
    expect(sent.has(topic('ubii_late'))).toBe(true);
  });
});
