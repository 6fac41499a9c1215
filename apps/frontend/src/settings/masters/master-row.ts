import { ClusterMasterState, type ClusterStatus } from '@ubii/proto';
import type { NamedMaster } from '../../connection/masters.ts';
import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { formatRate } from '../../ui/readouts/format-rate.ts';
import { formatMilliseconds, formatUptime } from '../../ui/readouts/format-time.ts';
import { NO_VALUE, type Readout } from '../../ui/readouts/readout.ts';
import type { MarkedState } from '../../ui/UiStateMark.vue';

/** A value of a row with its column. */
export interface MasterFigure {
  readonly name: string;
  readonly readout: Readout;
  /** Secondary value below. */
  readonly also?: Readout;
  readonly isWarning?: boolean;
}

/** A master of the cluster, as text. */
export interface MasterRow {
  readonly id: string;
  readonly label: string;
  readonly mark: MarkedState;
  readonly word: string;
  /** How long it has been in that state. */
  readonly since: string;
  readonly version: string;
  /** Its best address; `undefined` when it has none. */
  readonly address: string | undefined;
  readonly figures: readonly MasterFigure[];
}

/** Headings of the figures, in their order, with an explanation. */
export const MASTER_FIGURES: readonly { readonly name: string; readonly title: string }[] = [
  { name: 'Clients', title: 'Clients that are connected to this master' },
  { name: 'Sessions', title: 'Sessions that this master runs' },
  { name: 'Sent to', title: 'Records per second sent from the own master, and all bytes' },
  { name: 'Received', title: 'Records per second received by the own master, and all bytes' },
  { name: 'Round trip', title: 'From the own master through NATS and back' },
  { name: 'Dropped', title: 'Records that could not be sent as fast as they were published' },
  { name: 'Gaps', title: 'How often something was missing, and was requested again' },
];

/** @param nowMs epoch milliseconds, master's clock */
export function masterRow(
  { master, label }: NamedMaster,
  { reachable }: Pick<ClusterStatus, 'reachable'>,
  nowMs: number,
): MasterRow {
  const { mark, word } = lookOf(master, reachable);
  const values = isPresent(master) ? figuresOf(master) : [];
  const { clients, sessions, state } = master;
  const isOwn = state === ClusterMasterState.SELF;
  const own = [{ readout: count(clients) }, { readout: count(sessions) }];
  const all = isOwn || isPresent(master) ? [...own, ...values] : [];
  return {
    id: master.id,
    label,
    mark,
    word,
    since: formatUptime(nowMs - master.sinceMs),
    version: master.version,
    address: master.addresses[0],
    figures: MASTER_FIGURES.map(({ name }, index) => ({
      name,
      readout: NO_VALUE,
      ...all[index],
    })),
  };
}

type Master = NamedMaster['master'];
type Values = Omit<MasterFigure, 'name'>;

const isPresent = ({ state }: Master): boolean => state === ClusterMasterState.PRESENT;

const count = (value: number): Readout => ({ digits: formatNumber(value) });

function figuresOf(master: Master): Values[] {
  const { roundTripMs, dropped, gaps } = master;
  return [
    {
      readout: { digits: formatRate(master.recordsToPerSecond), unit: 'rec/s' },
      also: formatBytes(master.bytesToPerSecond, 'B/s'),
    },
    {
      readout: { digits: formatRate(master.recordsFromPerSecond), unit: 'rec/s' },
      also: formatBytes(master.bytesFromPerSecond, 'B/s'),
    },
    { readout: roundTripMs === 0 ? NO_VALUE : formatMilliseconds(roundTripMs) },
    { readout: count(dropped), isWarning: dropped > 0 },
    { readout: count(gaps), isWarning: gaps > 0 },
  ];
}

function lookOf(
  { state, complete }: Master,
  isReachable: boolean,
): { readonly mark: MarkedState; readonly word: string } {
  switch (state) {
    case ClusterMasterState.SELF:
      return isReachable
        ? { mark: 'live', word: 'own master' }
        : { mark: 'error', word: 'own master, alone' };
    case ClusterMasterState.PRESENT:
      return complete
        ? { mark: 'live', word: 'connected' }
        : { mark: 'warning', word: 'synchronizing' };
    case ClusterMasterState.ENDED:
      return { mark: 'stopped', word: 'ended' };
    default:
      return { mark: 'away', word: isReachable ? 'lost' : 'out of reach' };
  }
}
