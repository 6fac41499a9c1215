import { decode, encodeRecord, type TopicDataRecord } from '@ubii/proto';
import type { Access, BrokerClient } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { clientFrame, OPCODE } from '../load/frames.ts';
import type { StreamReceiver } from '../load/load-connection.ts';
import { createPictureRing, type RecordRing } from '../load/record-ring.ts';
import { WEB_SOCKET } from '../load/wire.ts';

const PHONES = 64;
const PER_SECOND = 60;
const STATE_BYTES = 2000;
const RECORD_TAG = 0x12;
const LOOK_MS = 1;
/** Room for the samples of a minute. */
const MAX_SAMPLES = 300_000;
const ROOMS = {
  phone: { publish: 'input', subscribe: 'state' },
  host: { publish: 'state', subscribe: 'input' },
};

/** Traffic of a party: 64 phones publish at 60 Hz to a host, which publishes a state of 2 KB at 60 Hz to all of them. */
export class PartyTraffic {
  readonly #ring: RecordRing;
  readonly #host: BrokerClient;
  readonly #inputs: InputVerifier;
  readonly #phones: readonly {
    readonly client: BrokerClient;
    readonly verifier: DeliveryVerifier;
  }[];
  readonly #sentMs = new Map<number, number>();
  readonly #samples = new Float64Array(MAX_SAMPLES);
  readonly #pressed = new Int32Array(PHONES);
  #sampleCount = 0;
  #isSampling = false;
  #sent = 0;
  #timer: NodeJS.Timeout | undefined;

  private constructor(parts: {
    ring: RecordRing;
    host: BrokerClient;
    inputs: InputVerifier;
    phones: readonly { client: BrokerClient; verifier: DeliveryVerifier }[];
  }) {
    this.#ring = parts.ring;
    this.#host = parts.host;
    this.#inputs = parts.inputs;
    this.#phones = parts.phones;
    for (const { verifier } of this.#phones) this.#watch(verifier);
  }

  static async open(access: Access): Promise<PartyTraffic> {
    const ring = createPictureRing('party-state', STATE_BYTES, 512);
    const inputs = new InputVerifier();
    const host = await access.join(
      { publishes: true, topics: [], patterns: [`^${INPUTS}\\d+$`], rooms: ROOMS.host },
      inputs,
    );
    const phones = [];
    for (let index = 0; index < PHONES; index += 1) {
      const verifier = new DeliveryVerifier(ring);
      const role = { publishes: true, topics: [ring.topic], rooms: ROOMS.phone };
      phones.push({ client: await access.join(role, verifier), verifier });
    }
    return new PartyTraffic({ ring, host, inputs, phones });
  }

  /** Begins to publish, phones one after the other within a sixtieth of a second. */
  play(): void {
    const startMs = performance.now();
    this.#timer = setInterval(() => {
      const steps = ((performance.now() - startMs) / 1000) * PER_SECOND;
      for (let phone = 0; phone < PHONES; phone += 1) {
        const due = Math.floor(steps - phone / PHONES) + 1;
        for (; this.#pressed[phone]! < due; this.#pressed[phone]! += 1) this.#press(phone);
      }
      for (; this.#sent < Math.floor(steps); this.#sent += 1) {
        this.#sentMs.set(this.#sent, performance.now());
        this.#host.connection.send(this.#ring.published.slice(this.#sent, 1));
      }
    }, LOOK_MS);
  }

  /** Notes from now on how long states take to reach phones. */
  sample(): void {
    this.#isSampling = true;
  }

  /** Ends. @returns how long states took, sorted, milliseconds; and what was not as it should be */
  async end(): Promise<{
    readonly sorted: Float64Array;
    readonly faults: string[];
    readonly records: number;
  }> {
    this.#isSampling = false;
    clearInterval(this.#timer);
    await new Promise((resolve) => setTimeout(resolve, 500));
    const faults: string[] = [];
    for (const { verifier } of this.#phones) {
      verifier.finish(this.#sent);
      const { lost, altered, repeated, unexpected } = verifier.faults;
      if (lost + altered + repeated > 0) faults.push(`${lost} states lost, ${altered} altered`);
      faults.push(...unexpected);
    }
    const pressed = this.#pressed.reduce((sum, count) => sum + count, 0);
    if (this.#inputs.count !== pressed) {
      faults.push(`${this.#inputs.count} of ${pressed} inputs arrived`);
    }
    faults.push(...this.#inputs.faults);
    const clients = [this.#host, ...this.#phones.map(({ client }) => client)];
    await Promise.all(clients.map((client) => client.leave()));
    const sorted = this.#samples.slice(0, this.#sampleCount).sort();
    return { sorted, faults: [...new Set(faults)], records: pressed + this.#sent * PHONES };
  }

  #press(phone: number): void {
    const record = encodeRecord({
      topic: `${INPUTS}${phone}`,
      format: 'vector3',
      value: { x: phone, y: this.#pressed[phone]!, z: 0.5 },
    });
    const message = Buffer.concat([Buffer.from([RECORD_TAG, record.length]), record]);
    this.#phones[phone]!.client.connection.send(clientFrame(OPCODE.binary, message));
  }

  #watch(verifier: DeliveryVerifier): void {
    let before = 0;
    verifier.onProgress = () => {
      const nowMs = performance.now();
      for (; before < verifier.next; before += 1) {
        const sentMs = this.#sentMs.get(before);
        if (!this.#isSampling || sentMs === undefined || this.#sampleCount >= MAX_SAMPLES) continue;
        this.#samples[this.#sampleCount] = nowMs - sentMs;
        this.#sampleCount += 1;
      }
    };
  }
}

const INPUTS = '/benchmark/party/input/';

/** Checks that each input arrives once, in the order of its phone. */
class InputVerifier implements StreamReceiver {
  count = 0;
  readonly faults: string[] = [];
  onPing: () => void = () => {};
  readonly #next = new Int32Array(PHONES);
  readonly #reader = WEB_SOCKET.openReader({
    handleTopicData: (bytes, start, end) => this.#handle(bytes.subarray(start, end)),
    handlePing: () => this.onPing(),
    handleOther: (what) => this.faults.push(what),
  });

  push(chunk: Buffer): void {
    this.#reader.push(chunk);
  }

  handleEnd(reason: string): void {
    this.faults.push(reason);
  }

  #handle(bytes: Buffer): void {
    const { topicDataRecord, topicDataRecordList } = decode('ubii.topicData.TopicData', bytes);
    if (topicDataRecord !== undefined) this.#check(topicDataRecord);
    for (const record of topicDataRecordList?.elements ?? []) this.#check(record);
  }

  #check({ vector3 }: TopicDataRecord): void {
    const { x = -1, y = -1 } = vector3 ?? {};
    if (this.#next[x] !== y && this.faults.length < 5) {
      this.faults.push(`input ${y} of phone ${x} came in place of ${this.#next[x]}`);
    }
    this.#next[x] = y + 1;
    this.count += 1;
  }
}
