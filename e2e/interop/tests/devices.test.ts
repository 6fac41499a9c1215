import { describe, expect, test } from 'vitest';
import { CLIENT_KINDS } from '../harness/client-kind.ts';
import { suiteName, useRoom, whyMissing } from '../harness/room.ts';

const room = useRoom();

/** Components in an order that no sorting gives, with the spellings that are in the wild. */
const DEVICE = {
  name: 'interop device',
  description: 'pointer and lamp',
  tags: ['interop', 'test'],
  components: [
    {
      name: 'pointer',
      topic: '/interop/pointer',
      messageFormat: 'ubii.dataStructure.Vector2',
      ioType: 'PUBLISHER',
      description: 'where the pointer is',
      tags: ['pointer'],
    },
    {
      name: 'lamp',
      topic: 'interop/lamp without a slash',
      messageFormat: 'boolean',
      ioType: 'SUBSCRIBER',
    },
    { name: 'angle', topic: '/interop/angle', messageFormat: 'double', ioType: 'PUBLISHER' },
  ],
};

/** The Python node takes the field names of the schema. */
function spelledFor(kind: string): object {
  if (kind !== 'python') return DEVICE;
  return {
    ...DEVICE,
    components: DEVICE.components.map(({ messageFormat, ioType, ...rest }) => ({
      ...rest,
      message_format: messageFormat,
      io_type: ioType === 'SUBSCRIBER' ? 1 : 0,
    })),
  };
}

describe.each(CLIENT_KINDS)('%s', (kind) => {
  describe.skipIf(whyMissing(kind))(suiteName(kind), () => {
    test('registers a device: the reply repeats everything, in order, with ids [DV-1]', async () => {
      const guest = await room.joins(kind);
      const device = await guest.registerDevice(spelledFor(kind));
      expect(device).toMatchObject({ ...DEVICE, clientId: guest.clientId });
      expect(device['id']).toMatch(/^[0-9a-f-]{36}$/);
      for (const component of device['components'] as Record<string, unknown>[]) {
        expect(component['id']).toMatch(/^[0-9a-f-]{36}$/);
        expect(component['deviceId']).toBe(device['id']);
      }
      expect(guest.complaints).toEqual([]);
    });

    test('its device is found by others: by tag, and component by component [CL-20]', async () => {
      const guest = await room.joins(kind);
      const device = await guest.registerDevice(spelledFor(kind));
      const ours = await room.oursJoins();
      const devices = await ours.call('deviceGetList', { elements: [{ tags: ['interop'] }] });
      expect(devices.elements.map(({ id }) => id)).toEqual([device['id']]);
      const components = await ours.call('componentGetList', {
        elements: [{ deviceId: String(device['id']) }],
      });
      expect(components.elements.map(({ name }) => name)).toEqual(['pointer', 'lamp', 'angle']);
    });
  });
});
