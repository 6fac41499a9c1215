// Lines for people who write a program: used by pages and docs. The programs are the files of `samples`.

/** Address of the master, and place of a token, in the samples. */
const ADDRESS = 'http://localhost:8080';
const TOKEN = 'TOKEN';

/** Returns the command that installs the library of a master. @param version of the master */
export function installCommand(masterUrl: string, version: string): string {
  return `npm i ${masterUrl}/sdk/ubii-client-${version}.tgz`;
}

/** Returns a sample with the address of a master, and with a token where it has a place for one. */
export function sampleFor(sample: string, masterUrl: string, token = TOKEN): string {
  return sample.replaceAll(ADDRESS, masterUrl).replaceAll(TOKEN, token);
}
