import { readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { ConfigError } from './config-error.ts';
import type { Given, GivenOptions } from './read-flags.ts';
import { flagName } from './option.ts';

/**
 * Reads options from a file with one JSON object.
 *
 * @param file its path
 * @param place of the option that names the file
 * @param fileOption name of that option
 * @param names of all options
 * @throws ConfigError for a file that cannot be read, and for an unknown key
 */
export function readConfigFile(
  file: string,
  place: string,
  fileOption: string,
  names: readonly string[],
): GivenOptions {
  const given = new Map<string, Given>();
  for (const [key, value] of Object.entries(readObject(file, place, flagName(fileOption)))) {
    if (key === fileOption || !names.includes(key)) {
      throw new ConfigError(
        `The config file ${file} has the key "${key}", which is not an option. Use --help to list all options.`,
      );
    }
    if (value === null) continue;
    if (typeof value === 'object' && !Array.isArray(value)) {
      throw new ConfigError(
        `The key "${key}" in the config file ${file} must be a text, a number, true, false or a list, but is an object.`,
      );
    }
    given.set(key, {
      text: Array.isArray(value) ? value.join(',') : String(value),
      place: `in the config file ${file}`,
      baseDir: dirname(resolve(file)),
    });
  }
  return given;
}

function readObject(file: string, place: string, flag: string): object {
  let content: unknown;
  try {
    content = JSON.parse(readFileSync(file, 'utf8'));
  } catch (error) {
    const reason = (error as Error).message.replace(/\.$/, '');
    throw new ConfigError(
      `The file given by ${flag} (${place}), ${file}, must be readable and contain JSON: ${reason}. Correct the file or remove ${flag}.`,
    );
  }
  if (typeof content !== 'object' || content === null || Array.isArray(content)) {
    throw new ConfigError(
      `The config file ${file} must contain one JSON object, such as { "port": 9000 }.`,
    );
  }
  return content;
}
