// A program with the command line of a master. The file `mode` in its data folder says what it does wrong.
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';

const args = process.argv.slice(2);
if (args.includes('--help')) {
  console.log('--port <number>\n--trust-loopback');
  process.exit(0);
}
const valueOf = (flag) => args[args.lastIndexOf(flag) + 1];
const file = join(valueOf('--data-dir'), 'mode');
const mode = existsSync(file) ? readFileSync(file, 'utf8') : '';
if (mode === 'refuse') {
  console.error('The port is taken.');
  process.exit(3);
}
console.error(JSON.stringify({ level: 'info', args }));
process.on('disconnect', () => process.exit(0));
process.on('SIGTERM', () => process.exit(0));
const server = createServer((_, response) => response.end('# HELP a\na{b="c d"} 2\ne 1.5\n'));
server.listen(Number(valueOf('--port')), '127.0.0.1', () => {
  const url = `http://127.0.0.1:${server.address().port}/`;
  console.log('The address of this master:');
  console.log(JSON.stringify({ url, pid: process.pid }));
});
