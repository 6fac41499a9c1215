import { arch, platform } from 'node:os';
import { sep } from 'node:path';
import { flagName, type Option } from '@ubii/program';
import type { Init, Setting, SettingList } from '@ubii/proto';

import { OPTIONS, type Config, type OptionName } from './config.ts';
import type { LegacyPorts } from './legacy-ports.ts';

/** Options that make the program do something else than run. */
const NO_SETTINGS: ReadonlySet<OptionName> = new Set(['help', 'version']);
/** What no value means that it is off. */
const OFF: ReadonlySet<OptionName> = new Set(['printEndpoints', 'flightRecorder']);

/**
 * The options in force, for people who see how a master is set up from elsewhere [EX-50].
 *
 * @param home the home folder, which is written `~`
 */
export function describeConfig(config: Config, home: string): Init<SettingList> {
  const names = (Object.keys(OPTIONS) as OptionName[]).filter((name) => !NO_SETTINGS.has(name));
  const elements = names.map((name): Init<Setting> => ({
    flag: flagName(name),
    value: textOf(config, name, home),
    description: OPTIONS[name].description,
    given: config.given.has(name),
  }));
  return { elements, runtime: `Node.js ${process.version}, ${platform()} ${arch()}` };
}

function textOf(config: Config, name: OptionName, home: string): string {
  const value: Config[OptionName] = config[name];
  const { isSecret }: Option<unknown> = OPTIONS[name];
  if (name === 'cluster') return config.cluster?.servers.join(', ') ?? 'none'; // Without its login.
  if (isSecret && value !== undefined) return 'given';
  if (name === 'legacyPorts' || name === 'zeromqPorts') return portsText(config[name]);
  if (name === 'limits') return limitsText(config.limits);
  if (value === undefined) return OFF.has(name) ? 'off' : 'none';
  if (typeof value === 'boolean') return value ? 'on' : 'off';
  if (Array.isArray(value)) return value.length === 0 ? 'none' : value.join(', ');
  return withoutHome(String(value), home);
}

function portsText(ports: LegacyPorts | undefined): string {
  return ports === undefined ? 'off' : `${ports.services},${ports.topicData}`;
}

function limitsText(limits: Config['limits']): string {
  const pairs = Object.entries(limits).map(([name, value]) => `${name}=${value}`);
  return pairs.length === 0 ? 'defaults' : pairs.join(', ');
}

function withoutHome(text: string, home: string): string {
  return text === home || text.startsWith(`${home}${sep}`) ? `~${text.slice(home.length)}` : text;
}
