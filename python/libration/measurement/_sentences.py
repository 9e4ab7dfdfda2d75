"""Sentences of the core, verdicts, guesses and reasons, in Portuguese of Brazil and Spanish.

A sentence is known by its English pattern, in which {} stands for what changes; numbers get a decimal comma. One that is not
known stays English.
"""

import functools
import re

# English: Portuguese, Spanish; {} are taken in their order, {0}, {1} where it differs.
PATTERNS = {
    # Verdicts.
    "too good: this is a linear cosine, computed and not measured (the linear equation leaves {} of the swing, the pendulum's {})": (
        "bom demais: isto é um cosseno linear, calculado e não medido (a equação linear deixa {} da amplitude, a do pêndulo {})",
        "demasiado bueno: esto es un coseno lineal, calculado y no medido (la ecuación lineal deja {} de la amplitud, la del péndulo {})",
    ),
    "the period does not depend on the swing: this is no angle of a pendulum (the linear equation leaves {} deg rms, the pendulum's {} deg)": (
        "o período não depende da amplitude: este não é o ângulo de um pêndulo (a equação linear deixa {} deg rms, a do pêndulo {} deg)",
        "el periodo no depende de la amplitud: este no es el ángulo de un péndulo (la ecuación lineal deja {} deg rms, la del péndulo {} deg)",
    ),
    "the period does not depend on the swing: this is no angle of a pendulum": (
        "o período não depende da amplitude: este não é o ângulo de um pêndulo",
        "el periodo no depende de la amplitud: este no es el ángulo de un péndulo",
    ),
    "too good: residuals of {} of the swing are below any sensor's noise": (
        "bom demais: resíduos de {} da amplitude estão abaixo do ruído de qualquer sensor",
        "demasiado bueno: residuos de {} de la amplitud están por debajo del ruido de cualquier sensor",
    ),
    "the unit is wrong: a scale of {} says that values read as {} are {}": (
        "a unidade está errada: uma escala de {} diz que os valores lidos como {} são {}",
        "la unidad es errónea: una escala de {} dice que los valores leídos como {} son {}",
    ),
    "the waveform is not a rigid pendulum's: with a scale of {} of the angle the rms falls by a factor of {}": (
        "a forma de onda não é a de um pêndulo rígido: com uma escala de {} do ângulo o rms cai por um fator de {}",
        "la forma de onda no es la de un péndulo rígido: con una escala de {} del ángulo el rms cae por un factor de {}",
    ),
    "the record asks for a scale of {} of its angle: with it the rms falls by a factor of {}": (
        "o registro pede uma escala de {} do seu ângulo: com ela o rms cai por um fator de {}",
        "el registro pide una escala de {} de su ángulo: con ella el rms cae por un factor de {}",
    ),
    "no motion of a pendulum describes the record: {} % of the swing is left": (
        "nenhum movimento de um pêndulo descreve o registro: sobra {} % da amplitude",
        "ningún movimiento de un péndulo describe el registro: queda un {} % de la amplitud",
    ),
    "the base moves or the friction law is wrong: {} % of the swing is left, from one sample to the next with a correlation of {}": (
        "a base se move ou a lei de atrito está errada: sobra {} % da amplitude, de uma amostra à seguinte com correlação de {}",
        "la base se mueve o la ley de rozamiento es errónea: queda un {} % de la amplitud, de una muestra a la siguiente con correlación de {}",
    ),
    "the linear friction is below 0: the dry friction falls while the velocity rises, by a law that is not quite that of the models": (
        "o atrito linear está abaixo de 0: o atrito seco cai enquanto a velocidade cresce, por uma lei que não é bem a dos modelos",
        "el rozamiento lineal está por debajo de 0: el rozamiento seco cae mientras la velocidad crece, por una ley que no es del todo la de los modelos",
    ),
    "a friction term wants to be negative and was held at 0: the friction law is not quite that of the models": (
        "um termo de atrito quer ser negativo e foi mantido em 0: a lei de atrito não é bem a dos modelos",
        "un término de rozamiento quiere ser negativo y se mantuvo en 0: la ley de rozamiento no es del todo la de los modelos",
    ),
    "omega0 is not constant: five windows of the record scatter by {} %": (
        "omega0 não é constante: cinco janelas do registro se dispersam em {} %",
        "omega0 no es constante: cinco ventanas del registro se dispersan un {} %",
    ),
    "the stated length is off by {} %: g would be {} m/s^2, and with g = {} the length is {} m": (
        "o comprimento indicado está errado em {} %: g seria {} m/s^2, e com g = {} o comprimento é {} m",
        "la longitud indicada está errada en un {} %: g sería {} m/s^2, y con g = {} la longitud es {} m",
    ),
    "the unit of the length or of the times is wrong: g would be {} m/s^2, {} times that of the Earth": (
        "a unidade do comprimento ou dos tempos está errada: g seria {} m/s^2, {} vezes o da Terra",
        "la unidad de la longitud o de los tiempos está equivocada: g sería {} m/s^2, {} veces el de la Tierra",
    ),
    "{} points per swing ({} samples in a period): another frequency may fit as well": (
        "{} pontos por oscilação ({} amostras em um período): outra frequência pode se ajustar igualmente",
        "{} puntos por oscilación ({} muestras en un periodo): otra frecuencia puede ajustarse igual de bien",
    ),
    "the record holds {} periods: friction and rest are hardly determined": (
        "o registro contém {} períodos: o atrito e o repouso são mal determinados",
        "el registro contiene {} periodos: el rozamiento y el reposo apenas quedan determinados",
    ),
    "the values depend on each other (condition {}): only their combination is known": (
        "os valores dependem uns dos outros (condição {}): só a combinação deles é conhecida",
        "los valores dependen unos de otros (condición {}): solo se conoce su combinación",
    ),
    "residuals follow each other (correlation {}): an uncertainty that takes them as independent would be {} times too small": (
        "os resíduos seguem uns aos outros (correlação {}): uma incerteza que os toma como independentes seria {} vezes pequena demais",
        "los residuos se siguen unos a otros (correlación {}): una incertidumbre que los toma como independientes sería {} veces demasiado pequeña",
    ),
    "residuals follow the velocity (correlation {}): the clock has faults": (
        "os resíduos seguem a velocidade (correlação {}): o relógio tem falhas",
        "los residuos siguen a la velocidad (correlación {}): el reloj tiene fallos",
    ),
    "the periods do not determine the swing: omega0 holds for small swings only": (
        "os períodos não determinam a amplitude: omega0 vale só para pequenas oscilações",
        "los periodos no determinan la amplitud: omega0 vale solo para oscilaciones pequeñas",
    ),
    "periods scatter by {} %: more than one mode moves, or passages were missed": (
        "os períodos se dispersam em {} %: mais de um modo se move, ou passagens foram perdidas",
        "los periodos se dispersan un {} %: se mueve más de un modo, o se perdieron pasos",
    ),
    "every stated length is short by {} m: it may end above the centre of the bob": (
        "a todo comprimento indicado faltam {} m: talvez termine acima do centro da massa",
        "a toda longitud indicada le faltan {} m: quizá termina por encima del centro de la masa",
    ),
    "both lengths agree on g = {} m/s^2 if each is short by {} m: a third length would tell": (
        "os dois comprimentos concordam em g = {} m/s^2 se a cada um faltam {} m: um terceiro comprimento decidiria",
        "las dos longitudes concuerdan en g = {} m/s^2 si a cada una le faltan {} m: una tercera longitud decidiría",
    ),
    "the records do not agree on {}: chi squared {} for {} degrees of freedom": (
        "os registros não concordam em {}: qui-quadrado {} para {} graus de liberdade",
        "los registros no concuerdan en {}: ji cuadrado {} para {} grados de libertad",
    ),
    "g = {} m/s^2 lies outside of {} to {} by more than its uncertainty: equal periods at equal distances, or a miscount": (
        "g = {} m/s^2 fica fora de {} a {} por mais que a sua incerteza: períodos iguais a distâncias iguais, ou um erro de contagem",
        "g = {} m/s^2 queda fuera de {} a {} por más que su incertidumbre: periodos iguales a distancias iguales, o un error de cuenta",
    ),
    # What was read.
    "Columns read, {}.": ("Colunas lidas, {}.", "Columnas leídas, {}."),
    "Column {} has no unit: taken as {} by its size (the largest, {}, {} {}); --unit angle=deg or =rad says otherwise.": (
        "A coluna {} não tem unidade: tomada como {} pelo tamanho (o maior, {}, {} {}); --unit angle=deg ou =rad diz outra coisa.",
        "La columna {} no tiene unidad: tomada como {} por su tamaño (el mayor, {}, {} {}); --unit angle=deg o =rad dice otra cosa.",
    ),
    "Column {} has no unit: taken as {} by its size ({}, {} {}).": (
        "A coluna {} não tem unidade: tomada como {} pelo tamanho ({}, {} {}).",
        "La columna {} no tiene unidad: tomada como {} por su tamaño ({}, {} {}).",
    ),
    "Column {} has no unit: taken as {}.": (
        "A coluna {} não tem unidade: tomada como {}.",
        "La columna {} no tiene unidad: tomada como {}.",
    ),
    "Column {} does not move: left out.": (
        "A coluna {} não se move: deixada de fora.",
        "La columna {} no se mueve: se deja fuera.",
    ),
    "Column {} is in a unit of its own: only the period can be used.": (
        "A coluna {} está em unidade própria: só o período pode ser usado.",
        "La columna {} está en una unidad propia: solo puede usarse el periodo.",
    ),
    "Column {} has decimal commas.": ("A coluna {} tem vírgulas decimais.", "La columna {} tiene comas decimales."),
    "The file has decimal commas.": ("O arquivo tem vírgulas decimais.", "El archivo tiene comas decimales."),
    "Column {} has thousands separators.": (
        "A coluna {} tem separadores de milhar.",
        "La columna {} tiene separadores de millares.",
    ),
    "Column {} and {} hold one angle: the first is taken.": (
        "A coluna {} e {} contêm um mesmo ângulo: a primeira é usada.",
        "La columna {} y {} contienen un mismo ángulo: se usa la primera.",
    ),
    "The unit {} of column {} is not known.": (
        "A unidade {} da coluna {} não é conhecida.",
        "La unidad {} de la columna {} no es conocida.",
    ),
    "{} samples from {} s to {} s, every {} s ({} to {}).": (
        "{} amostras de {} s a {} s, a cada {} s ({} a {}).",
        "{} muestras de {} s a {} s, cada {} s ({} a {}).",
    ),
    "Rest at {} deg: the zero of the angle is elsewhere, so fit an offset.": (
        "Repouso em {} deg: o zero do ângulo está em outro lugar e também é ajustado.",
        "Reposo en {} deg: el cero del ángulo está en otro lugar y también se ajusta.",
    ),
    "Rest at {} deg: subtracted.": ("Repouso em {} deg: subtraído.", "Reposo en {} deg: restado."),
    "The angle is wrapped: {} jumps of a turn are undone.": (
        "O ângulo está reduzido a uma volta: {} saltos de uma volta foram desfeitos.",
        "El ángulo está reducido a una vuelta: se deshacen {} saltos de una vuelta.",
    ),
    "Time is column {}, not {}.": ("O tempo é a coluna {}, não {}.", "El tiempo es la columna {}, no {}."),
    "Time is column {}: it rises by even steps.": (
        "O tempo é a coluna {}: cresce em passos iguais.",
        "El tiempo es la columna {}: crece en pasos iguales.",
    ),
    "The angle is column {}: no other column moves with the time.": (
        "O ângulo é a coluna {}: nenhuma outra coluna se move com o tempo.",
        "El ángulo es la columna {}: ninguna otra columna se mueve con el tiempo.",
    ),
    "The angular velocity is column {}, the axis that moves most{}.": (
        "A velocidade angular é a coluna {}, o eixo que mais se move{}.",
        "La velocidad angular es la columna {}, el eje que más se mueve{}.",
    ),
    "; another axis has {} % of it": ("; outro eixo tem {} % dela", "; otro eje tiene el {} % de ella"),
    "along the path; {} is radial and swings twice in a period": (
        "ao longo da trajetória; {} é radial e oscila duas vezes por período",
        "a lo largo de la trayectoria; {} es radial y oscila dos veces por periodo",
    ),
    "an accelerometer in {}": ("um acelerômetro em {}", "un acelerómetro en {}"),
    "Columns {} to {} are {} by their size.": (
        "As colunas {} a {} são {} pelo tamanho.",
        "Las columnas {} a {} son {} por su tamaño.",
    ),
    "The acceleration is column {}, {}.": ("A aceleração é a coluna {}, {}.", "La aceleración es la columna {}, {}."),
    "Columns {} and {} lie on a circle: a position x, y.": (
        "As colunas {} e {} estão em um círculo: uma posição x, y.",
        "Las columnas {} y {} están en un círculo: una posición x, y.",
    ),
    "The pivot is {}: ({}, {}), {} from the track, which is {} % of that off its circle; down is {}.": (
        "O pivô é {}: ({}, {}), a {} da trajetória, que se afasta do seu círculo em {} % disso; para baixo é {}.",
        "El pivote es {}: ({}, {}), a {} de la trayectoria, que se aparta de su círculo un {} % de eso; hacia abajo es {}.",
    ),
    "A gap of {} s after {} s (paused?).": (
        "Uma lacuna de {} s após {} s (pausa?).",
        "Un hueco de {} s tras {} s (¿pausa?).",
    ),
    "{} gaps in all.": ("{} lacunas ao todo.", "{} huecos en total."),
    "The clock steps back {} times, first from {} to {} in line {}: the order is kept, fit the sides apart.": (
        "O relógio recua {} vezes, primeiro de {} a {} na linha {}: a ordem é mantida, ajuste os lados em separado.",
        "El reloj retrocede {} veces, primero de {} a {} en la línea {}: se mantiene el orden, ajuste los lados por separado.",
    ),
    "Times are rounded until several are equal, and no even rate explains them: kept as written.": (
        "Os tempos estão arredondados até vários serem iguais, e nenhuma taxa constante os explica: mantidos como escritos.",
        "Los tiempos están redondeados hasta ser varios iguales, y ninguna tasa constante los explica: se dejan como están.",
    ),
    "No column of times: {} samples in a second, as a line above the rows says.": (
        "Sem coluna de tempos: {} amostras por segundo, como diz uma linha acima.",
        "Sin columna de tiempos: {} muestras por segundo, como dice una línea de arriba.",
    ),
    "Events of a light gate, not samples: dark while 1; the times are those when it became dark.": (
        "Eventos de uma fotoporta, não amostras: escuro enquanto 1; os tempos são os do começo do escuro.",
        "Eventos de una fotopuerta, no muestras: oscuro mientras 1; los tiempos son los del comienzo de la oscuridad.",
    ),
    "A period is the time to the second passage after: each swing passes the gate twice.": (
        "Um período é o tempo até a segunda passagem seguinte: cada oscilação passa duas vezes pela fotoporta.",
        "Un periodo es el tiempo hasta el segundo paso siguiente: cada oscilación pasa dos veces por la fotopuerta.",
    ),
    "{} gates in the file ({}): {} read; --run N chooses.": (
        "{} fotoportas no arquivo ({}): {} lida; --run N escolhe.",
        "{} fotopuertas en el archivo ({}): {} leída; --run N elige.",
    ),
    "The last passage is open: its time in the dark is unknown.": (
        "A última passagem está aberta: seu tempo no escuro é desconhecido.",
        "El último paso está abierto: su tiempo en la oscuridad es desconocido.",
    ),
    "The file is {}.": ("O arquivo é {}.", "El archivo es {}."),
    "The file is {} without a mark.": ("O arquivo é {} sem marca.", "El archivo es {} sin marca."),
    "The file is no UTF-8: read as Latin-1.": (
        "O arquivo não é UTF-8: lido como Latin-1.",
        "El archivo no es UTF-8: leído como Latin-1.",
    ),
    "{} {} in the file: {} read, {} rows; --run N chooses.": (
        "{} {} no arquivo: {} lido, {} linhas; --run N escolhe.",
        "{} {} en el archivo: {} leído, {} filas; --run N elige.",
    ),
    "Times: {} out of order, {} {}; sorted, the first of equal ones kept.": (
        "Tempos: {} fora de ordem, {} {}; ordenados, o primeiro dos iguais mantido.",
        "Tiempos: {} fuera de orden, {} {}; ordenados, se mantiene el primero de los iguales.",
    ),
    "Times are rounded until several are equal: rebuilt as {} s + i/{}, of which each is a rounding.": (
        "Os tempos estão arredondados até vários serem iguais: refeitos como {} s + i/{}, de que cada um é um arredondamento.",
        "Los tiempos están redondeados hasta ser varios iguales: rehechos como {} s + i/{}, de lo que cada uno es un redondeo.",
    ),
    "The clock wraps{}: {} is added at each fall.": (
        "O relógio recomeça{}: {} é somado a cada queda.",
        "El reloj vuelve a empezar{}: se suma {} en cada caída.",
    ),
    "A table of a light gate: periods, not samples.": (
        "Uma tabela de fotoporta: períodos, não amostras.",
        "Una tabla de fotopuerta: periodos, no muestras.",
    ),
    "A table of periods against angles of release, not a record in time.": (
        "Uma tabela de períodos por ângulo de soltura, não um registro no tempo.",
        "Una tabla de periodos por ángulo de suelta, no un registro en el tiempo.",
    ),
    "The file states a standard uncertainty of {}, in the unit of the column, for every value.": (
        "O arquivo indica uma incerteza-padrão de {}, na unidade da coluna, para cada valor.",
        "El archivo indica una incertidumbre típica de {}, en la unidad de la columna, para cada valor.",
    ),
    # What was left out.
    "{} row: {} (line {})": ("{} linha: {} (linha {})", "{} fila: {} (línea {})"),
    "{} rows: {} (lines {})": ("{} linhas: {} (linhas {})", "{} filas: {} (líneas {})"),
    "outlier": ("ponto discrepante", "punto discrepante"),
    "outlier: beyond 6 deviations": ("ponto discrepante", "punto discrepante"),
    "no number": ("sem número", "sin número"),
    "no number, or a period that is not positive": (
        "sem número, ou um período que não é positivo",
        "sin número, o un periodo que no es positivo",
    ),
    "a passage was missed or counted twice": (
        "uma passagem foi perdida ou contada duas vezes",
        "un paso se perdió o se contó dos veces",
    ),
    "a time far from those before and after": (
        "um tempo longe dos vizinhos",
        "un tiempo lejos de los vecinos",
    ),
    "the time of the row before": ("o tempo da linha anterior", "el tiempo de la fila anterior"),
    "no row of the table": ("não é linha da tabela", "no es fila de la tabla"),
    "cut short": ("interrompida", "interrumpida"),
    "empty": ("vazia", "vacía"),
    "a passage missed: the period is too long": (
        "uma passagem perdida: o período é longo demais",
        "un paso perdido: el periodo es demasiado largo",
    ),
    "a passage too many: the period is too short": (
        "uma passagem a mais: o período é curto demais",
        "un paso de más: el periodo es demasiado corto",
    ),
    "no time": ("sem tempo", "sin tiempo"),
    "no value in column {}": ("sem valor na coluna {}", "sin valor en la columna {}"),
    "no number in column {}": ("sem número na coluna {}", "sin número en la columna {}"),
}
# What fills a place of a pattern and has words of its own.
PIECES = {
    "a gyroscope": ("um giroscópio", "un giroscopio"),
    "the axis that moves most": ("o eixo que mais se move", "el eje que más se mueve"),
    "degrees": ("graus", "grados"),
    "radians": ("radianos", "radianes"),
    "two": ("dois", "dos"),
    "three": ("três", "tres"),
    "exceeds": ("passa de", "pasa de"),
    "does not exceed": ("não passa de", "no pasa de"),
    "runs": ("medições", "mediciones"),
    "data sets": ("conjuntos de dados", "conjuntos de datos"),
    "duplicate": ("repetido", "repetido"),
    "duplicates": ("repetidos", "repetidos"),
    "the origin of the axes": ("a origem dos eixos", "el origen de los ejes"),
    "the centre of the track's circle": (
        "o centro do círculo da trajetória",
        "el centro del círculo de la trayectoria",
    ),
    "the origin of the axes (the arc is too short for a circle)": (
        "a origem dos eixos (o arco é curto demais para um círculo)",
        "el origen de los ejes (el arco es demasiado corto para un círculo)",
    ),
    "the time": ("o tempo", "el tiempo"),
    "the angle": ("o ângulo", "el ángulo"),
    "the position": ("a posição", "la posición"),
    "the period": ("o período", "el periodo"),
    "the period and how long a passage is dark": (
        "o período e o tempo no escuro de uma passagem",
        "el periodo y el tiempo en la oscuridad de un paso",
    ),
    "the angular velocity": ("a velocidade angular", "la velocidad angular"),
    "the acceleration": ("a aceleração", "la aceleración"),
    "the angle of release and the period": ("o ângulo de soltura e o período", "el ángulo de suelta y el periodo"),
}
NUMBER = re.compile(r"[-+−]?[0-9]+\.[0-9]+(e[-+]?[0-9]+)?")


@functools.cache
def compiled() -> list[tuple[re.Pattern[str], tuple[str, str]]]:
    """The patterns as expressions, those with more fixed letters first."""
    ordered = sorted(PATTERNS.items(), key=lambda each: -len(each[0].replace("{}", "")))
    return [
        (re.compile(re.escape(english).replace(r"\{\}", "(.*?)") + r"\Z", re.DOTALL), other)
        for english, other in ordered
    ]


def in_language(sentence: str, language: str) -> str:
    """A sentence of the core in Portuguese or Spanish; as it is where its pattern is not known."""
    for pattern, others in compiled():
        if found := pattern.match(sentence):
            return others[language == "es"].format(*(piece(part, language) for part in found.groups()))
    return sentence


def piece(part: str, language: str) -> str:
    """What fills a place: a number, a known text, a sentence of its own, or names, which stay."""
    if NUMBER.fullmatch(part):
        return part.replace(".", ",")
    told = in_language(part, language)
    if told != part:
        return told
    if part in PIECES:
        return PIECES[part][language == "es"]
    for english, others in PIECES.items():
        part = re.sub(rf"(^|; ){re.escape(english)}: ", rf"\1{others[language == 'es']}: ", part)
    return part
