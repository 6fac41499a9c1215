import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Counts events, and resets its count on request. */
export const counter = defineProcessingModule({
  name: 'counter',
  description: 'Counts true values; reset sets the count to 0.',
  tags: ['event', 'number', 'counter'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    event: { format: 'bool', description: 'Each true counts as one event.' },
    reset: { format: 'bool', description: 'True sets the count to 0.' },
    step: {
      format: 'int32',
      default: 1,
      description: 'Increment for each event, may be negative.',
    },
  },
  outputs: {
    count: { format: 'int32', description: 'The count.' },
  },
  mode: { triggerOnInput: {} },
  createState: (): { count: number; told: number | undefined; wasOn: boolean } => ({
    count: 0,
    told: undefined,
    wasOn: false,
  }),
  onProcessing(_deltaTimeMs, inputs, state) {
    const step = (inputs.step as NumberRecord | undefined)?.int32 ?? 1;
    const isOn = inputs.event?.bool === true;
    // In a mode without triggers, only the change from false to true is an event.
    const triggers = state.inputTriggerNames ?? [];
    const isEvent = triggers.length > 0 ? isOn && triggers.includes('event') : isOn && !state.wasOn;
    state.wasOn = isOn;
    const isReset =
      inputs.reset?.bool === true && (triggers.length === 0 || triggers.includes('reset'));
    // Wrap around at the ends of int32.
    if (isReset) state.count = 0;
    else if (isEvent) state.count = (state.count + step) | 0;
    if (state.told === state.count) return undefined;
    state.told = state.count;
    return { outputs: { count: { int32: state.count } } };
  },
});
