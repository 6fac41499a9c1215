import { messageDescriptor, type MessageDescriptor, type MessageTypes } from '@ubii/proto';
import { firstCharacters, hasMoreCharacters, isLongerThan, isOneLine, oneLine } from '@ubii/words';
import { LIMITS, type LimitName, type Limits } from '../limits/index.ts';
import { LISTED_TEXTS, TEXT_RULES, type TextRule } from './text-limits.ts';

/** A text, or a list of texts, that is refused because it is too long. */
export interface TextFault {
  /** Path, such as `session.io_mappings[3].input_mappings[0].input_name`. */
  readonly member: string;
  readonly limit: LimitName;
  /** Length, in the unit of the limit. */
  readonly length: number;
}

/** Messages of clients: requests, and reports of nodes. */
type Root =
  | 'ubii.services.ServiceRequest'
  | 'ubii.extension.ModuleStatistics'
  | 'ubii.extension.ModuleEvent'
  | 'ubii.extension.Recording'
  | 'ubii.extension.BridgeMappings';

/** Limits and state of checking the texts of a message. */
export interface TextContext {
  readonly limits: Limits;
  /** Makes the error for a text that is refused. */
  readonly refuse: (fault: TextFault) => Error;
}

/** Members that hold texts, by their JSON names. */
type Plan = ReadonlyMap<string, TextPlan | MessagePlan>;

interface TextPlan {
  readonly protoName: string;
  readonly rule: Extract<TextRule, { limit: LimitName }>;
  /** Treatment of lists with too many elements; undefined when their number is limited elsewhere. */
  readonly listed: 'refuse' | 'cut' | undefined;
}

interface MessagePlan {
  readonly protoName: string;
  readonly plan: Plan;
}

type Fields = Readonly<Record<string, unknown>>;

const PLANS: { readonly [R in Root]: Plan } = plansOf();

/**
 * The message with every text as long as it may be [EX-70] [EX-71]: itself when nothing is too long, else a
 * copy with texts cut.
 *
 * @throws what `context.refuse` makes, for a text that is not cut
 */
export function boundTexts<R extends Root>(
  type: R,
  message: MessageTypes[R],
  context: TextContext,
): MessageTypes[R] {
  return new Walk(context).message(
    PLANS[type],
    message as object as Fields,
  ) as object as MessageTypes[R];
}

/** The same for a message whose texts are all cut and never refused. */
export function cutTexts<R extends Exclude<Root, 'ubii.services.ServiceRequest'>>(
  type: R,
  message: MessageTypes[R],
  limits: Limits,
): MessageTypes[R] {
  return boundTexts(type, message, { limits, refuse: ({ member }) => new RangeError(member) });
}

/** One walk through a message. */
class Walk {
  readonly #context: TextContext;
  readonly #path: (string | number)[] = [];

  constructor(context: TextContext) {
    this.#context = context;
  }

  /** Goes through the members that are there: a request has some 100, of which two are set. */
  message(plan: Plan, fields: Fields): Fields {
    let bounded: Record<string, unknown> | undefined;
    for (const jsonName in fields) {
      const given = fields[jsonName];
      if (given === undefined || given === '') continue;
      const member = plan.get(jsonName);
      if (member === undefined) continue;
      this.#path.push(member.protoName);
      const kept = 'plan' in member ? this.#messages(member, given) : this.#texts(member, given);
      this.#path.pop();
      if (kept !== given) (bounded ??= { ...fields })[jsonName] = kept;
    }
    return bounded ?? fields;
  }

  #messages({ plan }: MessagePlan, given: unknown): unknown {
    return Array.isArray(given)
      ? this.#list(given as readonly Fields[], (element) => this.message(plan, element))
      : this.message(plan, given as Fields);
  }

  #texts(plan: TextPlan, given: unknown): unknown {
    if (typeof given === 'string') return this.#text(plan, given);
    const texts = given as readonly string[];
    const { textsPerList } = this.#context.limits;
    const isTooLong = plan.listed !== undefined && texts.length > textsPerList;
    if (isTooLong && plan.listed === 'refuse') this.#refuse('textsPerList', texts.length);
    const kept = isTooLong ? texts.slice(0, textsPerList) : texts;
    return this.#list(kept, (text) => this.#text(plan, text));
  }

  /** The same list when every element stays the same. */
  #list<T>(list: readonly T[], bound: (element: T) => T): readonly T[] {
    let bounded: T[] | undefined;
    for (const [i, element] of list.entries()) {
      this.#path.push(i);
      const kept = bound(element);
      this.#path.pop();
      if (kept !== element) (bounded ??= [...list])[i] = kept;
    }
    return bounded ?? list;
  }

  #text({ rule: { limit, over } }: TextPlan, text: string): string {
    const max = this.#context.limits[limit];
    const isInBytes = LIMITS[limit].unit === 'bytes';
    const isTooLong = isInBytes ? isLongerThan(text, max) : hasMoreCharacters(text, max);
    if (over === 'line') return isTooLong || !isOneLine(text) ? oneLine(text, max) : text;
    if (!isTooLong) return text;
    if (over === 'cut') return firstCharacters(text, max);
    return this.#refuse(limit, text.length);
  }

  #refuse(limit: LimitName, length: number): never {
    const member = this.#path.reduce<string>(
      (path, part) => (typeof part === 'number' ? `${path}[${part}]` : `${path}.${part}`),
      '',
    );
    throw this.#context.refuse({ member: member.slice(1), limit, length });
  }
}

function plansOf(): { readonly [R in Root]: Plan } {
  const known = new Map<MessageDescriptor, Plan>();
  const planOf = (type: Root): Plan => planMessage(messageDescriptor(type), known);
  return {
    'ubii.services.ServiceRequest': planOf('ubii.services.ServiceRequest'),
    'ubii.extension.ModuleStatistics': planOf('ubii.extension.ModuleStatistics'),
    'ubii.extension.ModuleEvent': planOf('ubii.extension.ModuleEvent'),
    'ubii.extension.Recording': planOf('ubii.extension.Recording'),
    'ubii.extension.BridgeMappings': planOf('ubii.extension.BridgeMappings'),
  };
}

/** @throws RangeError when a text has no row in the table */
function planMessage(descriptor: MessageDescriptor, known: Map<MessageDescriptor, Plan>): Plan {
  const before = known.get(descriptor);
  if (before !== undefined) return before;
  const plan = new Map<string, TextPlan | MessagePlan>();
  known.set(descriptor, plan);
  if (TEXT_RULES[descriptor.name] !== undefined) return plan;
  for (const { type, jsonName, protoName } of descriptor.fields) {
    const name = `${descriptor.name}.${protoName}`;
    if (type === 'string') {
      const rule = TEXT_RULES[name];
      if (rule === undefined) {
        throw new RangeError(
          `Text "${name}" has no limit. Add a row to TEXT_RULES in text-limits.ts.`,
        );
      }
      if ('limit' in rule) plan.set(jsonName, { protoName, rule, listed: LISTED_TEXTS[name] });
    } else if (typeof type === 'object' && type.kind === 'message') {
      plan.set(jsonName, { protoName, plan: planMessage(type, known) });
    }
  }
  return plan;
}
