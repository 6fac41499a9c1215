import { startProgram } from '@ubii/client-web/node';
import { defineProcessingModule, startModules } from '@ubii/client-web/processing';

const [url = 'http://localhost:8080', joinToken] = process.argv.slice(2);
const client = await startProgram({ url, name: 'first module', joinToken });
const loudness = defineProcessingModule({
  name: 'loudness',
  inputs: { level: 'double' },
  outputs: { text: 'string' },
  mode: { triggerOnInput: {} },
  onProcessing: (_deltaTimeMs, { level }) => ({
    outputs: { text: { string: (level?.double ?? 0) > 0.5 ? 'loud' : 'quiet' } },
  }),
});
await startModules(client, [loudness]);
console.log(`${loudness.name} is offered by ${client.name}`);
