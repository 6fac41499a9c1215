/** Ids of masters are UUIDs; nothing else becomes a part of a subject. */
const UUID = /^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$/;

export function isMasterId(text: string): boolean {
  return UUID.test(text);
}

/** Subjects of the messages between masters, `ubii.<cluster>.…`. [CU-50] */
export class BusSubjects {
  readonly #cluster: string;
  readonly #own: string;

  /** @param masterId of the master that sends */
  constructor(cluster: string, masterId: string) {
    this.#cluster = cluster;
    this.#own = masterId;
  }

  /** What others send to this master. */
  get forOwn(): string {
    return `ubii.${this.#cluster}.to.${this.#own}.*`;
  }

  /** What others send to every master. */
  get forAll(): string {
    return `ubii.${this.#cluster}.all.*`;
  }

  to(receiver: string): string {
    return `ubii.${this.#cluster}.to.${receiver}.${this.#own}`;
  }

  get toAll(): string {
    return `ubii.${this.#cluster}.all.${this.#own}`;
  }
}

/** @returns the id of the master that sent to this subject; undefined when no master did */
export function senderOf(subject: string): string | undefined {
  const sender = subject.slice(subject.lastIndexOf('.') + 1);
  return isMasterId(sender) ? sender : undefined;
}
