import { expect, it } from 'vitest';
import { previewFrame } from './preview-frame.ts';
import { PreviewMemory } from './preview-memory.ts';

it('writes values at the ends of lines no longer than their place', () => {
  const memory = new PreviewMemory('/x/');
  const record = { topic: '/x/b', timestampMs: undefined, clientId: '' };
  memory.take({ ...record, format: 'double', value: -0.0016 }, 0);
  const view = {
    kind: 'lines',
    lines: [{ topic: 'b', letter: 'b', stroke: 'solid' }],
    range: [-1.6, 1.6],
  } as const;
  expect(previewFrame(view, memory, 0).labels).toMatchObject([{ letter: 'b', text: '0.00' }]);
});
