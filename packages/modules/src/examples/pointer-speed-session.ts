import type { Init, Session } from '@ubii/proto';

/** A position goes in, a speed comes out. It runs at a frequency, so the speed of a resting pointer is 0. */
export const pointerSpeedSession = {
  name: 'pointer-speed',
  description: 'Velocity and speed of the position on one topic.',
  tags: ['example'],
  processingModules: [{ name: 'speed-vector2', processingMode: { frequency: { hertz: 30 } } }],
  ioMappings: [
    {
      processingModuleName: 'speed-vector2',
      inputMappings: [
        { inputName: 'position', topic: '/examples/pointer-speed/pointer' },
        { inputName: 'smoothingMs', constantJson: '{"double":150}' },
      ],
      outputMappings: [
        { outputName: 'speed', topic: '/examples/pointer-speed/speed' },
        { outputName: 'velocity', topic: '/examples/pointer-speed/velocity' },
      ],
    },
  ],
} satisfies Init<Session>;
