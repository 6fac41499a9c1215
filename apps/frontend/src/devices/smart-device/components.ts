import type { ComponentInit } from '@ubii/client-web';

/** Name that existing programs look for. */
export const SMART_DEVICE = 'web-interface-smart-device';

/** Shortest interval between moves of fingers, milliseconds; starts and ends are sent at once. */
export const TOUCH_MOVE_INTERVAL_MS = 16;

const own = (name: string) => (clientId: string) => `/${clientId}/${SMART_DEVICE}/${name}`;

/**
 * Components of a smart device. The first four have the names, topics and tags that existing programs rely on,
 * including the missing leading slash of the orientation's topic.
 */
export const SMART_DEVICE_COMPONENTS = [
  {
    name: 'web-component-linear-acceleration',
    format: 'vector3',
    topic: own('linear_acceleration'),
    tags: ['acceleration', 'linear'],
    description: 'Acceleration without gravity, m/s², in the axes of the device.',
  },
  {
    name: 'web-component-orientation',
    format: 'vector3',
    topic: (clientId: string) => `${clientId}/orientation`,
    tags: ['imu', 'orientation'],
    description: 'Degrees about z, x and y (alpha, beta, gamma), relative to the calibration.',
  },
  {
    name: 'web-component-touch',
    format: 'touchEventList',
    topic: (clientId: string) => `/${clientId}/touch_events`,
    tags: ['touch'],
    description: 'Fingers on the pad, 0 to 1 on both axes, origin top left.',
  },
  {
    name: 'web-component-vibration',
    format: 'double',
    ioType: 'subscriber',
    topic: (clientId: string) => `/${clientId}/vibration_pattern`,
    tags: ['vibration'],
    description: 'Vibration time, milliseconds; without vibration the page flashes.',
  },
  {
    name: 'touch_position',
    format: 'vector2',
    topic: own('touch_position'),
    tags: ['touch', 'pointer'],
    description: 'The first finger on the pad, 0 to 1 on both axes, origin top left.',
  },
  {
    name: 'is_touched',
    format: 'bool',
    topic: own('is_touched'),
    tags: ['touch'],
    description:
      'Whether a finger is on the pad; published at once when the last finger is lifted.',
  },
  {
    name: 'acceleration',
    format: 'vector3',
    topic: own('acceleration'),
    tags: ['acceleration'],
    description: 'Acceleration with gravity, m/s², in the axes of the device.',
  },
  {
    name: 'rotation_rate',
    format: 'vector3',
    topic: own('rotation_rate'),
    tags: ['imu', 'gyroscope'],
    description: 'Degrees per second about z, x and y (alpha, beta, gamma).',
  },
  {
    name: 'orientation_quaternion',
    format: 'quaternion',
    topic: own('orientation_quaternion'),
    tags: ['imu', 'orientation'],
    description: 'Rotation since the calibration, unit quaternion.',
  },
  {
    name: 'compass',
    format: 'double',
    topic: own('compass'),
    tags: ['compass'],
    description: 'Heading of the top edge, degrees clockwise from north.',
  },
  {
    name: 'location',
    format: 'vector4',
    topic: own('location'),
    tags: ['location'],
    description: 'Latitude, longitude (degrees), altitude (m), radius of uncertainty (m).',
  },
  {
    name: 'microphone_level',
    format: 'double',
    topic: own('microphone_level'),
    tags: ['microphone', 'level'],
    description: 'Loudness, 0 to 1; no sound leaves the phone.',
  },
  {
    name: 'button',
    format: 'keyEvent',
    topic: own('button'),
    tags: ['button'],
    description: 'The buttons 1, 2 and 3, pressed and released.',
  },
  {
    name: 'text',
    format: 'string',
    topic: own('text'),
    tags: ['text'],
    description: 'The text that the user sent.',
  },
  {
    name: 'battery',
    format: 'double',
    topic: own('battery'),
    tags: ['status'],
    description: 'Charge, 0 to 1, where the browser provides it.',
  },
  {
    name: 'visible',
    format: 'bool',
    topic: own('visible'),
    tags: ['status'],
    description: 'Whether the page is visible.',
  },
  {
    name: 'is_near',
    format: 'bool',
    ioType: 'subscriber',
    topic: own('is_near'),
    tags: ['near'],
    description:
      'Whether another finger is near this one, as found by the smart-device gatherer example.',
  },
  {
    name: 'set_color',
    format: 'color',
    ioType: 'subscriber',
    topic: own('set_color'),
    tags: ['color'],
    description: 'Fills the pad; an alpha of 0 removes the colour.',
  },
  {
    name: 'play_tone',
    format: 'vector3',
    ioType: 'subscriber',
    topic: own('play_tone'),
    tags: ['sound'],
    description: 'A tone: frequency (Hz), duration (ms), volume (0 to 1).',
  },
  {
    name: 'show_text',
    format: 'string',
    ioType: 'subscriber',
    topic: own('show_text'),
    tags: ['text'],
    description: 'Text shown over the pad; an empty text removes it.',
  },
  {
    name: 'show_image',
    format: 'image2D',
    ioType: 'subscriber',
    topic: own('show_image'),
    tags: ['image'],
    description: 'A picture shown behind the fingers.',
  },
] as const satisfies readonly ComponentInit[];

export type SmartDeviceComponents = typeof SMART_DEVICE_COMPONENTS;
