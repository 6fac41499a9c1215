import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../fixtures/call-service.ts';

export const DEVICE = 'web-interface-smart-device';

/**
 * A session in which the place of a finger becomes a colour, which the phone shows.
 * @returns its id
 */
export async function lampSession(master: MasterProcess, phone: string): Promise<string> {
  const own = (name: string): string => `/${phone}/${DEVICE}/${name}`;
  const soft = crypto.randomUUID();
  const steady = crypto.randomUUID();
  const hue = crypto.randomUUID();
  const speed = crypto.randomUUID();
  const nodes = {
    [`topic:${own('touch_position')}`]: { kind: 'topic', x: 0, y: 56 },
    [`topic:${own('acceleration')}`]: { kind: 'topic', x: 0, y: 248 },
    [`module:${soft}`]: { kind: 'module', x: 214, y: 0 },
    [`module:${steady}`]: { kind: 'module', x: 214, y: 216 },
    [`module:${hue}`]: { kind: 'module', x: 515, y: 0 },
    [`module:${speed}`]: { kind: 'module', x: 515, y: 200 },
    [`topic:${own('set_color')}`]: { kind: 'topic', x: 774, y: 0 },
    [`topic:${own('show_text')}`]: { kind: 'topic', x: 774, y: 100 },
    'topic:/lamp/speed': { kind: 'topic', x: 774, y: 250 },
    'topic:/lamp/tilt': { kind: 'topic', x: 515, y: 420 },
  };
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: {
      name: 'Light in the hand',
      processingModules: [
        { id: soft, name: 'low-pass-vector2' },
        { id: steady, name: 'low-pass-vector3' },
        { id: hue, name: 'position-color' },
        { id: speed, name: 'speed-vector2' },
      ],
      ioMappings: [
        {
          processingModuleId: soft,
          inputMappings: [{ inputName: 'value', topic: own('touch_position') }],
          outputMappings: [{ outputName: 'smoothed', topic: '/lamp/position' }],
        },
        {
          processingModuleId: steady,
          inputMappings: [{ inputName: 'value', topic: own('acceleration') }],
          outputMappings: [{ outputName: 'smoothed', topic: '/lamp/tilt' }],
        },
        {
          processingModuleId: hue,
          inputMappings: [{ inputName: 'position', topic: '/lamp/position' }],
          outputMappings: [
            { outputName: 'color', topic: own('set_color') },
            { outputName: 'hex', topic: own('show_text') },
          ],
        },
        {
          processingModuleId: speed,
          inputMappings: [{ inputName: 'position', topic: '/lamp/position' }],
          outputMappings: [{ outputName: 'speed', topic: '/lamp/speed' }],
        },
      ],
      extension: {
        editorJson: JSON.stringify({ format: 'ubi-interact.graph', version: 1, nodes }),
      },
    },
  });
  return session!.id;
}
