import type { Init, Session } from '@ubii/proto';

/** Computes the speed of a position. Runs at a frequency, so that the speed of a resting pointer is 0. */
export const pointerSpeedSession = {
  name: 'Pointer speed',
  description: 'Computes the velocity and the speed of a position.',
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
