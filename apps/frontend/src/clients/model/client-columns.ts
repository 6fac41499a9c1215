import { ClientActivityAddressKind, ClientState, type ClientActivity } from '@ubii/proto';
import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { formatRate } from '../../ui/readouts/format-rate.ts';
import { formatAge } from '../../ui/readouts/format-time.ts';
import { NO_VALUE, type Readout } from '../../ui/readouts/readout.ts';
import { clockAhead, clockOf } from './client-clock.ts';
import type { ClientView } from './client-view.ts';

/** Property of a client: column of the table while there is room, and sort criterion. */
export interface ClientColumn {
  readonly key: ClientColumnKey;
  /** Heading of the column. */
  readonly head: string;
  /** Full name, used without context. */
  readonly title: string;
  /** Width of the column, pixels; 0: never a column. */
  readonly width: number;
  /** Precedence of columns when space is short: lower numbers stay. */
  readonly priority: number;
  /** Initial direction of sorting. */
  readonly first: 'ascending' | 'descending';
  readonly isText?: boolean;
  /** Value for sorting; `undefined` is last. */
  valueOf(view: ClientView): number | string | undefined;
  /** @param nowMs master's clock, epoch milliseconds */
  show(view: ClientView, nowMs: number): Readout;
  /** True for values that are highlighted. */
  isWarning?(view: ClientView): boolean;
}

export type ClientColumnKey =
  | 'name'
  | 'master'
  | 'state'
  | 'trip'
  | 'clock'
  | 'in'
  | 'bytesIn'
  | 'out'
  | 'bytesOut'
  | 'queue'
  | 'dropped'
  | 'refused'
  | 'subscriptions'
  | 'topics'
  | 'work'
  | 'modules'
  | 'seen'
  | 'first'
  | 'throttle'
  | 'agent'
  | 'address';

/** Round trip from which users notice a delay, milliseconds. */
const SLOW_MS = 50;
/** Rate below which a value is shown as zero. */
const NOTHING = 0.05;

const ADDRESSES: Record<ClientActivity['addressKind'], string> = {
  [ClientActivityAddressKind.UNKNOWN]: '',
  [ClientActivityAddressKind.LOOPBACK]: 'this computer',
  [ClientActivityAddressKind.PRIVATE]: 'local network',
  [ClientActivityAddressKind.PUBLIC]: 'beyond',
};

/** Network location of a client, as seen from the master; empty when unknown. */
export const addressWords = (kind: ClientActivity['addressKind']): string => ADDRESSES[kind] ?? '';

type Show = (value: number) => Readout;
const count: Show = (value) => ({ digits: formatNumber(value) });
const rate: Show = (value) => ({ digits: value < NOTHING ? '0' : formatRate(value) });
const bytes: Show = (value) => formatBytes(value, '');
const trip: Show = (ms) => ({ digits: ms < 1 ? '<1' : formatNumber(ms), unit: 'ms' });
const percent: Show = (share) => ({ digits: formatNumber(share * 100), unit: '%' });

type NumberColumn = Omit<ClientColumn, 'show' | 'valueOf' | 'first' | 'isText'>;

/** Column of a number of the report, highest first. */
function measured(
  column: NumberColumn,
  read: (activity: ClientActivity, view: ClientView) => number | undefined,
  show: Show,
): ClientColumn {
  const valueOf = (view: ClientView): number | undefined =>
    view.activity && read(view.activity, view);
  return {
    ...column,
    first: 'descending',
    valueOf,
    show(view) {
      const value = valueOf(view);
      return value === undefined ? NO_VALUE : show(value);
    },
  };
}

/** Column of a time, shown as its age, most recent first. */
function moment(column: NumberColumn, read: (activity: ClientActivity) => number): ClientColumn {
  return {
    ...column,
    first: 'descending',
    valueOf: ({ activity }) => activity && read(activity),
    show: ({ activity }, nowMs) => {
      const ms = activity === undefined ? 0 : read(activity);
      return ms === 0 ? NO_VALUE : formatAge(nowMs - ms);
    },
  };
}

const words = (text: string): Readout => (text === '' ? NO_VALUE : { digits: text });

/** Round trip to a client, milliseconds; `undefined` while it is away or not measured. */
export function tripMs({ client, activity }: ClientView): number | undefined {
  if (client.state !== ClientState.ACTIVE) return undefined;
  return activity?.roundTripMs || client.latency || undefined;
}

const subscriptionsOf = (activity: ClientActivity): number =>
  activity.topicSubscriptions + activity.patternSubscriptions + activity.componentSubscriptions;

export const CLIENT_COLUMNS: readonly ClientColumn[] = [
  {
    key: 'name',
    head: 'Client',
    title: 'Name',
    width: 0,
    priority: 0,
    first: 'ascending',
    isText: true,
    valueOf: ({ label }) => label.toLocaleLowerCase(),
    show: ({ label }) => words(label),
  },
  {
    key: 'master',
    head: 'Master',
    title: 'Master',
    width: 116,
    priority: 2,
    first: 'ascending',
    isText: true,
    valueOf: ({ master }) => master.toLocaleLowerCase() || undefined,
    show: ({ master }) => words(master),
  },
  {
    key: 'state',
    head: 'State',
    title: 'State',
    width: 92,
    priority: 3,
    first: 'ascending',
    isText: true,
    valueOf: ({ client, isBroken }) => (isBroken ? -1 : client.state),
    show: ({ look }) => words(look.word),
  },
  {
    key: 'trip',
    head: 'Round trip',
    title: 'Round trip',
    width: 76,
    priority: 2,
    first: 'descending',
    valueOf: tripMs,
    show: (view) => {
      const ms = tripMs(view);
      return ms === undefined ? NO_VALUE : trip(ms);
    },
    isWarning: (view) => (tripMs(view) ?? 0) > SLOW_MS,
  },
  measured(
    {
      key: 'in',
      head: 'Sends /s',
      title: 'Published records per second',
      width: 68,
      priority: 1,
    },
    ({ recordsInPerSecond }) => recordsInPerSecond,
    rate,
  ),
  measured(
    {
      key: 'bytesIn',
      head: 'Sends B/s',
      title: 'Published bytes per second',
      width: 74,
      priority: 6,
    },
    ({ bytesInPerSecond }) => bytesInPerSecond,
    bytes,
  ),
  measured(
    {
      key: 'out',
      head: 'Gets /s',
      title: 'Received records per second',
      width: 68,
      priority: 1,
    },
    ({ recordsOutPerSecond }) => recordsOutPerSecond,
    rate,
  ),
  measured(
    {
      key: 'bytesOut',
      head: 'Receives B/s',
      title: 'Received bytes per second',
      width: 74,
      priority: 6,
    },
    ({ bytesOutPerSecond }) => bytesOutPerSecond,
    bytes,
  ),
  {
    ...measured(
      { key: 'queue', head: 'Queue', title: 'Queued bytes', width: 64, priority: 4 },
      ({ queuedBytes }) => queuedBytes,
      bytes,
    ),
    isWarning: ({ activity }) => (activity?.queuedRecords ?? 0) > 0,
  },
  {
    ...measured(
      {
        key: 'dropped',
        head: 'Dropped',
        title: 'Records dropped before delivery',
        width: 64,
        priority: 5,
      },
      ({ dropped }) => dropped,
      count,
    ),
    isWarning: ({ activity }) => (activity?.dropped ?? 0) > 0,
  },
  {
    ...measured(
      {
        key: 'refused',
        head: 'Refused',
        title: 'Published records that the master refused',
        width: 64,
        priority: 7,
      },
      ({ refused }) => refused,
      count,
    ),
    isWarning: ({ activity }) => (activity?.refused ?? 0) > 0,
  },
  measured(
    { key: 'subscriptions', head: 'Subscr.', title: 'Subscriptions', width: 60, priority: 7 },
    subscriptionsOf,
    count,
  ),
  measured(
    {
      key: 'topics',
      head: 'Topics',
      title: 'Topics with a retained value of this client',
      width: 56,
      priority: 9,
    },
    ({ ownedTopics }) => ownedTopics,
    count,
  ),
  measured(
    { key: 'work', head: 'Work', title: 'Share of forwarding work', width: 56, priority: 5 },
    ({ workShare }) => workShare,
    percent,
  ),
  {
    key: 'modules',
    head: 'Modules',
    title: 'Own modules',
    width: 62,
    priority: 10,
    first: 'descending',
    valueOf: ({ client }) => client.processingModules.length,
    show: ({ client }) => count(client.processingModules.length),
  },
  moment(
    { key: 'seen', head: 'Seen', title: 'Last seen', width: 62, priority: 8 },
    ({ lastSeenMs }) => lastSeenMs,
  ),
  moment(
    { key: 'first', head: 'Since', title: 'First seen', width: 62, priority: 9 },
    ({ firstSeenMs }) => firstSeenMs,
  ),
  {
    ...measured(
      { key: 'throttle', head: 'Throttle', title: 'Active throttle', width: 0, priority: 0 },
      ({ throttle }) => throttle?.recordsPerSecond,
      (value) => ({ digits: formatRate(value), unit: '/s' }),
    ),
    isWarning: ({ activity }) => activity?.throttle !== undefined,
  },
  {
    key: 'agent',
    head: 'Agent',
    title: 'Browser or library',
    width: 0,
    priority: 0,
    first: 'ascending',
    isText: true,
    valueOf: ({ agent }) => agent.toLocaleLowerCase() || undefined,
    show: ({ agent }) => words(agent),
  },
  {
    key: 'clock',
    head: 'Clock',
    title: 'Clock offset, ahead of the master',
    width: 76,
    priority: 9,
    first: 'descending',
    valueOf: (view) => {
      const clock = clockOf(view);
      return clock && Math.abs(clock.offsetMs);
    },
    show: (view) => {
      const clock = clockOf(view);
      return clock === undefined ? NO_VALUE : clockAhead(clock);
    },
  },
  {
    key: 'address',
    head: 'Address',
    title: 'Kind of address',
    width: 92,
    priority: 11,
    first: 'ascending',
    isText: true,
    valueOf: ({ activity }) =>
      activity ? addressWords(activity.addressKind) || undefined : undefined,
    show: ({ activity }) => words(activity ? addressWords(activity.addressKind) : ''),
  },
];

const BY_KEY = new Map(CLIENT_COLUMNS.map((column) => [column.key as string, column]));

export const clientColumn = (key: ClientColumnKey): ClientColumn => BY_KEY.get(key)!;

/** Returns the column with a key; `undefined` for other texts. */
export const findClientColumn = (key: string): ClientColumn | undefined => BY_KEY.get(key);

/** Width of name, actions and padding, pixels. */
const NAME_WIDTH = 300;

/** Returns all columns: that of masters only where there are several. */
export function knownColumns(hasMasters: boolean): readonly ClientColumn[] {
  return hasMasters ? CLIENT_COLUMNS : CLIENT_COLUMNS.filter(({ key }) => key !== 'master');
}

/** Returns the columns that fit beside the name, by precedence, in display order. */
export function columnsThatFit(width: number, hasMasters = false): readonly ClientColumn[] {
  const wanted = knownColumns(hasMasters)
    .filter((column) => column.width > 0)
    .sort((a, b) => a.priority - b.priority);
  let left = width - NAME_WIDTH;
  const taken = new Set<ClientColumn>();
  for (const column of wanted) {
    if (column.width > left) break;
    left -= column.width;
    taken.add(column);
  }
  return CLIENT_COLUMNS.filter((column) => taken.has(column));
}
