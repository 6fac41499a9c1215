import type { SandboxInput } from '../../ports/sandbox.ts';
import type { EncodedRecord } from '../../ports/topic-port.ts';
import { constantRecord } from './constant-record.ts';
import type { InputSlot, SlotContext, SlotSpec } from './input-slot.ts';

/** An input mapped to a constant: encoded once. [PM-34] */
export class ConstantSlot implements InputSlot {
  readonly name: string;
  readonly isLive = false;
  isMarked = false;
  readonly #input: SandboxInput;

  constructor(spec: SlotSpec, context: SlotContext) {
    this.name = spec.name;
    const constant = constantRecord(spec.mapping.constantJson, spec.format);
    if ('problem' in constant) context.onProblem(spec.name, constant.problem);
    const record = 'problem' in constant ? undefined : { bytes: constant.bytes };
    this.#input = { name: spec.name, record };
  }

  get hasValue(): boolean {
    return 'record' in this.#input && this.#input.record !== undefined;
  }

  markValue(): void {
    this.isMarked = this.hasValue;
  }

  takeMark(): void {
    this.isMarked = false;
  }

  read(): SandboxInput {
    return this.#input;
  }

  readFrom(): SandboxInput {
    return this.#input;
  }

  records(): Iterable<EncodedRecord> {
    return [];
  }

  listen(): void {}

  close(): void {}
}
